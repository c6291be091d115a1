#include "programs/trace_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <utility>

namespace kerf::program {

TraceWriter::TraceWriter(std::string name, Descriptor descriptor, double period_s,
                         TraceColumns columns)
    : name_(std::move(name)),
      descriptor_(std::move(descriptor)),
      clock_(period_s),
      columns_(std::move(columns)),
      buffer_(kBufferBytes) {
  const std::string header = trace_header(columns_);
  std::copy(header.begin(), header.end(), buffer_.begin());
  used_ = header.size();
}

tl::expected<TraceWriter, std::string> TraceWriter::create(const std::string& path, double period_s,
                                                           TraceColumns columns) {
  const bool is_output = path == "-";
  const std::string name = is_output ? "<stdout>" : path;
  Descriptor file(is_output ? ::dup(STDOUT_FILENO)
                            : ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!file.is_open()) {
    return tl::unexpected(name + ": " + error_text(errno));
  }
  return TraceWriter(name, std::move(file), period_s, std::move(columns));
}

void TraceWriter::add(const TickRecord& record) {
  if (!descriptor_.is_open()) {
    return;
  }
  if (buffer_.size() - used_ < kMaxRowBytes) {
    flush();
  }
  char* const at = buffer_.data() + used_;
  used_ += static_cast<std::size_t>(write_row(at, record, clock_, columns_) - at);
}

void TraceWriter::close() {
  flush();
  if (const int error = descriptor_.close()) {
    note(error);
  }
}

void TraceWriter::flush() {
  const std::size_t count = std::exchange(used_, 0);
  if (!descriptor_.is_open()) {
    return;
  }
  if (const int error = write_all(descriptor_.number(), {buffer_.data(), count})) {
    note(error);
    descriptor_.close();
  }
}

void TraceWriter::note(int error_number) {
  if (error_number == EPIPE) {
    reader_gone_ = true;
  } else if (!error_) {
    error_ = name_ + ": " + error_text(error_number);
  }
}

}  // namespace kerf::program
