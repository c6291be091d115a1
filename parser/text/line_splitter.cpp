#include "parser/text/line_splitter.hpp"

#include <algorithm>

namespace kerf::parser {

namespace {

std::size_t find(const std::string& bytes, char wanted, std::size_t from) {
  return std::min(bytes.find(wanted, from), bytes.size());
}

}  // namespace

void LineSplitter::feed(std::string_view bytes) {
  buffer_.erase(0, at_);
  scanned_ = scanned_ > at_ ? scanned_ - at_ : 0;
  buffer_.append(bytes);
  // What was looked through before is not again, however much of it is still to be read.
  for (LineEnd& end : ends_) {
    end.next = find(buffer_, end.byte, end.next < at_ ? scanned_ : end.next - at_);
  }
  at_ = 0;
}

// What belongs to the line end before: one LF after a CR, any CRs after an LF. (LF CR LF counts
// the same whether it is read as LF, CRLF or as LFCR, LF.)
void LineSplitter::skip_rest_of_line_end() {
  while (ended_by_ != '\0' && at_ < buffer_.size()) {
    const char rest = ended_by_ == '\r' ? '\n' : '\r';
    const bool skipped = buffer_[at_] == rest;
    at_ += skipped ? 1 : 0;
    if (!skipped || rest == '\n') {
      ended_by_ = '\0';
    }
  }
}

std::size_t LineSplitter::find_line_end() {
  const std::size_t from = std::max(at_, scanned_);
  for (LineEnd& end : ends_) {
    if (end.next < from) {
      end.next = find(buffer_, end.byte, from);
    }
  }
  return std::min(ends_[0].next, ends_[1].next);
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

void LineSplitter::take(std::size_t length, NumberedLine& line) {
  line = {std::string_view(buffer_).substr(at_, length), ++lines_};
  at_ += length;
}

bool LineSplitter::next(NumberedLine& line) {
  if (dropping_ && !drop_rest_of_long_line()) {
    return false;
  }
  skip_rest_of_line_end();
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
