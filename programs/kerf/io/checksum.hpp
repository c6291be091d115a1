// A number that tells whether bytes are what they were.
#pragma once

#include <cstdint>
#include <string_view>

#include <boost/crc.hpp>

namespace kerf::program {

// CRC-64/XZ, for accidents: whoever means to can make bytes that have it.
class Checksum {
 public:
  void add(std::string_view bytes) { crc_.process_bytes(bytes.data(), bytes.size()); }
  [[nodiscard]] std::uint64_t value() const { return crc_.checksum(); }

 private:
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693U, 0xFFFFFFFFFFFFFFFFU, 0xFFFFFFFFFFFFFFFFU, true, true>
      crc_;
};

}  // namespace kerf::program
