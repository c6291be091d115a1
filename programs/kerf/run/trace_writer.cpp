#include "programs/kerf/run/trace_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <utility>

#include <boost/algorithm/string/predicate.hpp>

#include "programs/kerf/run/trace_npy.hpp"

namespace kerf::program {

TraceWriter::TraceWriter(OutputFile file, const TraceSettings& settings)
    : file_(std::move(file)),
      clock_(settings.period_s),
      settings_(settings),
      is_npy_(boost::algorithm::iends_with(file_.name(), ".npy")),
      buffer_(kBufferBytes) {
  const std::string header =
      is_npy_ ? npy_header(settings_.columns, 0) : trace_header(settings_.columns);
  std::copy(header.begin(), header.end(), buffer_.begin());
  used_ = header.size();
}

tl::expected<TraceWriter, std::string> TraceWriter::create(const std::string& path,
                                                           const TraceSettings& settings) {
  auto file = OutputFile::create(path);
  if (!file) {
    return tl::unexpected(file.error());
  }
  return TraceWriter(*std::move(file), settings);
}

// No tick before one time and none after the other; but for rounding.
bool TraceWriter::is_wanted(std::int64_t tick) const noexcept {
  constexpr double kRounding = 1e-6;
  const auto at = static_cast<double>(tick);
  return tick % settings_.ticks.every == 0 &&
         at >= settings_.ticks.from_s / settings_.period_s - kRounding &&
         at <= settings_.ticks.to_s / settings_.period_s + kRounding;
}

void TraceWriter::add(const TickRecord& record) {
  if (closed_ || ended() || !is_wanted(record.tick)) {
    return;
  }
  line_ = record.line;
  if (buffer_.size() - used_ < kMaxRowBytes) {
    flush();
  }
  char* const at = buffer_.data() + used_;
  const char* const end_of_row =
      is_npy_ ? write_npy_row(at, record, settings_.period_s, settings_.columns)
              : write_row(at, record, clock_, settings_.columns);
  const auto bytes = static_cast<std::size_t>(end_of_row - at);
  if (written_bytes_ + used_ + bytes > settings_.max_bytes) {
    flush();
    end("would be larger than " + std::to_string(settings_.max_bytes) + " bytes (--max-trace)");
    return;
  }
  used_ += bytes;
  ++rows_;
}

void TraceWriter::close(bool lacks_rows) {
  if (closed_) {
    return;
  }
  flush();
  write_count();
  closed_ = true;
  if (const int error = file_.finish(!ended() && !lacks_rows)) {
    note(error);
  }
}

void TraceWriter::flush() {
  const std::size_t count = std::exchange(used_, 0);
  if (ended()) {
    return;
  }
  written_bytes_ += count;
  if (const int error = file_.write({buffer_.data(), count})) {
    note(error);
  }
}

void TraceWriter::write_count() {
  if (!is_npy_ || is_broken_) {
    return;
  }
  if (const int error = file_.write_again(npy_header(settings_.columns, rows_))) {
    note(error);
  }
}

void TraceWriter::note(int error_number) {
  is_broken_ = true;
  if (error_number == EPIPE && file_.is_standard_output()) {
    reader_gone_ = true;
  } else if (error_number == EINTR) {
    end("nobody reads it");
  } else {
    end(error_text(error_number));
  }
}

void TraceWriter::end(const std::string& why) {
  if (!ended()) {
    error_ = file_.name() + ": " + why + ", in line " + std::to_string(line_);
  }
}

}  // namespace kerf::program
