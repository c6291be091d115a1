#include "kernel/program_state.hpp"

#include <utility>

namespace kerf {
inline namespace v0 {

ProgramState::ProgramState(Content content) : content_(new Content(std::move(content))) {}
ProgramState::ProgramState(const ProgramState& other)
    : content_(other.content_ == nullptr ? nullptr : new Content(*other.content_)) {}
ProgramState::~ProgramState() {
  delete content_;
}

}  // namespace v0
}  // namespace kerf
