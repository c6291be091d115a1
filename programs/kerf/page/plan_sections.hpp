// The parts of a plan after its header: docs/page-data.md.
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "programs/kerf/page/packed_numbers.hpp"

namespace kerf::program {

class Sections {
 public:
  // How the numbers of a section are to be read.
  struct Shape {
    std::string name;
    double unit = 1.0;
  };
  template <typename Values, typename ToWhole>
  void add_numbers(const Shape& shape, const Values& values, ToWhole to_whole) {
    PackedNumbers packed;
    for (const auto& value : values) {
      packed.add(to_whole(value));
    }
    add_packed(shape, values.size(), packed);
  }
  void add_packed(const Shape& shape, std::size_t count, const PackedNumbers& packed) {
    list_.push_back({{"name", shape.name},
                     {"coding", "differences"},
                     {"unit", shape.unit},
                     {"count", count},
                     {"bytes", packed.bytes().size()}});
    bytes_ += packed.bytes();
  }
  void add_bytes(const std::string& name, std::string_view bytes) {
    list_.push_back(
        {{"name", name}, {"coding", "bytes"}, {"count", bytes.size()}, {"bytes", bytes.size()}});
    bytes_ += bytes;
  }
  // For the header: each with its line.
  [[nodiscard]] const nlohmann::ordered_json& list() const noexcept { return list_; }
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  nlohmann::ordered_json list_ = nlohmann::ordered_json::array();
  std::string bytes_;
};

}  // namespace kerf::program
