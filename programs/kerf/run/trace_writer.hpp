// The trace file: one row per tick, or per some ticks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "programs/kerf/io/output_file.hpp"
#include "programs/kerf/run/trace_row.hpp"

namespace kerf::program {

// Which ticks have a row: every so many-th of those from one time to another.
struct TraceTicks {
  std::int64_t every = 1;  // > 0
  double from_s = 0.0;
  double to_s = std::numeric_limits<double>::infinity();
};

struct TraceSettings {
  double period_s = 0.001;
  TraceColumns columns{};
  TraceTicks ticks{};
  std::uint64_t max_bytes = std::numeric_limits<std::uint64_t>::max();
};

// After the first error nothing more is written: the file then has the beginning of the trace, in
// whole rows unless the disk is full, and error() says why it ends.
class TraceWriter {
 public:
  // path "-" is standard output, NAME.npy an array of NumPy, any other name CSV. Error: what the
  // system says, with the path.
  static tl::expected<TraceWriter, std::string> create(const std::string& path,
                                                       const TraceSettings& settings);

  void add(const TickRecord& record);
  // Writes what is left. The writer takes no more rows. lacks_rows: some never came here.
  void close(bool lacks_rows = false);

  // No row follows any more, for an error or because the reader has gone.
  [[nodiscard]] bool ended() const noexcept { return error_ || reader_gone_; }
  [[nodiscard]] const std::optional<std::string>& error() const noexcept { return error_; }
  // The reader of standard output went away, which is its right and no error.
  [[nodiscard]] bool reader_gone() const noexcept { return reader_gone_; }
  [[nodiscard]] const OutputFile& file() const noexcept { return file_; }
  [[nodiscard]] std::string remains() const { return file_.remains(); }

 private:
  static constexpr std::size_t kBufferBytes = std::size_t{256} * 1024;

  TraceWriter(OutputFile file, const TraceSettings& settings);
  [[nodiscard]] bool is_wanted(std::int64_t tick) const noexcept;
  void flush();
  // NPY says at its begin how many rows there are.
  void write_count();
  void note(int error_number);
  void end(const std::string& why);

  OutputFile file_;
  TickClock clock_;
  TraceSettings settings_;
  bool is_npy_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
  std::uint64_t written_bytes_ = 0;
  std::uint64_t rows_ = 0;
  std::uint32_t line_ = 0;  // of the last row
  bool closed_ = false;
  bool is_broken_ = false;  // a write failed
  std::optional<std::string> error_;
  bool reader_gone_ = false;
};

}  // namespace kerf::program
