#include "programs/kerf/run/trace_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>

namespace kerf::program {

TraceWriter::TraceWriter(OutputFile file, const TraceSettings& settings)
    : file_(std::move(file)),
      clock_(settings.period_s),
      columns_(settings.columns),
      buffer_(kBufferBytes),
      max_bytes_(settings.max_bytes) {
  const std::string header = trace_header(columns_);
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

void TraceWriter::add(const TickRecord& record) {
  if (closed_ || ended()) {
    return;
  }
  line_ = record.line;
  if (buffer_.size() - used_ < kMaxRowBytes) {
    flush();
  }
  char* const at = buffer_.data() + used_;
  const auto bytes = static_cast<std::size_t>(write_row(at, record, clock_, columns_) - at);
  if (written_bytes_ + used_ + bytes > max_bytes_) {
    flush();
    end("would be larger than " + std::to_string(max_bytes_) + " bytes (--max-trace)");
    return;
  }
  used_ += bytes;
}

void TraceWriter::close(bool lacks_rows) {
  if (closed_) {
    return;
  }
  flush();
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

void TraceWriter::note(int error_number) {
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
