#include "kernel/program_notes.hpp"

#include <limits>
#include <utility>

namespace kerf {

void ProgramNotes::read(const parser::ProgramReader& reader) {
  messages_.insert(messages_.end(), reader.messages().begin(), reader.messages().end());
  read_codes_ = reader.codes();
}

void ProgramNotes::move(const parser::Move& move) {
  if (codes_ahead_.empty() ? read_codes_ != codes_ : read_codes_ != codes_ahead_.back().text) {
    codes_ahead_.push_back({.block = move.block, .text = read_codes_});
  }
}

void ProgramNotes::reach(std::uint64_t block) {
  while (!messages_.empty() && messages_.front().block <= block) {
    reached_messages_.push_back(std::move(messages_.front().message));
    messages_.pop_front();
  }
  while (!codes_ahead_.empty() && codes_ahead_.front().block <= block) {
    codes_ = std::move(codes_ahead_.front().text);
    codes_ahead_.pop_front();
  }
}

void ProgramNotes::reach_end() {
  reach(std::numeric_limits<std::uint64_t>::max());
}

std::vector<ProgramMessage> ProgramNotes::take_messages() {
  return std::exchange(reached_messages_, {});
}

}  // namespace kerf
