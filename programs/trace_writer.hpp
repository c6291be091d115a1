// The trace file: one row per tick.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "programs/descriptor.hpp"
#include "programs/trace_row.hpp"

namespace kerf::program {

// After the first error nothing more is written: what is on the disk then is the beginning of the
// trace, and error() says why it ends.
class TraceWriter {
 public:
  // path "-" is standard output. Error: what the system says, with the path.
  static tl::expected<TraceWriter, std::string> create(const std::string& path, double period_s,
                                                       TraceColumns columns = {});

  void add(const TickRecord& record);
  // Writes what is left. The writer takes no more rows.
  void close();

  [[nodiscard]] const std::optional<std::string>& error() const noexcept { return error_; }
  // The reader of the pipe went away, which is its right and no error.
  [[nodiscard]] bool reader_gone() const noexcept { return reader_gone_; }

 private:
  static constexpr std::size_t kBufferBytes = std::size_t{256} * 1024;

  TraceWriter(std::string name, Descriptor descriptor, double period_s, TraceColumns columns);
  void flush();
  void note(int error_number);

  std::string name_;
  Descriptor descriptor_;
  TickClock clock_;
  TraceColumns columns_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
  std::optional<std::string> error_;
  bool reader_gone_ = false;
};

}  // namespace kerf::program
