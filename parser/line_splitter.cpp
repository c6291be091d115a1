#include "parser/line_splitter.hpp"

#include <algorithm>
#include <cstring>

namespace kerf::parser {

namespace {

std::size_t find(const std::string& bytes, char wanted, std::size_t from) {
  if (from >= bytes.size()) {
    return bytes.size();
  }
  const void* const found = std::memchr(bytes.data() + from, wanted, bytes.size() - from);
  return found == nullptr
             ? bytes.size()
             : static_cast<std::size_t>(static_cast<const char*>(found) - bytes.data());
}

}  // namespace

void LineSplitter::feed(std::string_view bytes) {
  buffer_.erase(0, at_);
  scanned_ = scanned_ > at_ ? scanned_ - at_ : 0;
  at_ = 0;
  buffer_.append(bytes);
  next_cr_ = find(buffer_, '\r', scanned_);
}

// The second byte of CRLF or LFCR. False: it cannot be told yet.
bool LineSplitter::skip_rest_of_line_end() {
  while (ended_by_ != '\0') {
    if (at_ == buffer_.size()) {
      return finished_;
    }
    const char c = buffer_[at_];
    if (ended_by_ == '\r') {
      at_ += c == '\n' ? 1 : 0;
      ended_by_ = '\0';
    } else if (c != '\r') {
      ended_by_ = '\0';
    } else if (at_ + 1 == buffer_.size() && !finished_) {
      return false;
    } else if (at_ + 1 < buffer_.size() && buffer_[at_ + 1] == '\n') {
      ended_by_ = '\0';  // an empty line that ends with CRLF
    } else {
      ++at_;
    }
  }
  return true;
}

std::size_t LineSplitter::find_line_end() {
  const std::size_t from = std::max(at_, scanned_);
  const std::size_t lf = find(buffer_, '\n', from);
  if (next_cr_ < from) {
    next_cr_ = find(buffer_, '\r', from);
  }
  return std::min(lf, next_cr_);
}

bool LineSplitter::drop_rest_of_long_line() {
  const std::size_t end = find_line_end();
  if (end == buffer_.size()) {
    at_ = scanned_ = end;
    return false;
  }
  ended_by_ = buffer_[end];
  at_ = end + 1;
  dropping_ = false;
  return true;
}

void LineSplitter::take(std::size_t length, Line& line) {
  line = {std::string_view(buffer_).substr(at_, length), ++lines_, false};
  at_ += length;
}

bool LineSplitter::next(Line& line) {
  if ((dropping_ && !drop_rest_of_long_line()) || !skip_rest_of_line_end()) {
    return false;
  }
  const std::size_t end = find_line_end();
  if (end - at_ > kMaxLine) {
    take(kMaxLine, line);
    line.too_long = true;
    dropping_ = true;
    return true;
  }
  if (end < buffer_.size()) {
    take(end - at_, line);
    ended_by_ = buffer_[at_++];
    return true;
  }
  scanned_ = end;
  if (!finished_ || at_ == end) {
    return false;
  }
  take(end - at_, line);
  return true;
}

}  // namespace kerf::parser
