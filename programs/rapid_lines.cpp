#include "programs/rapid_lines.hpp"

#include <utility>

namespace kerf::program {

RapidLines::RapidLines(ProgramFile file, bool block_delete)
    : file_(std::move(file)), reader_({.block_delete = block_delete}) {
  file_.rewind();
}

bool RapidLines::read_move() {
  while (!reader_.next(move_)) {
    if (reader_.at_end()) {
      return false;
    }
    const auto piece = file_.read();
    if (!piece) {
      return false;
    }
    if (piece->empty()) {
      reader_.finish();
    } else {
      reader_.feed(*piece);
    }
  }
  return true;
}

bool RapidLines::is_rapid(std::uint32_t line) {
  while (!at_end_ && move_.source.line < line) {
    at_end_ = !read_move();
  }
  // A line may hold an event beside its motion; any rapid on it makes it one.
  while (!at_end_ && move_.source.line == line) {
    is_rapid_ = move_.rapid;
    if (is_rapid_) {
      break;
    }
    at_end_ = !read_move();
  }
  return is_rapid_;
}

}  // namespace kerf::program
