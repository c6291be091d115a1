// G66: the macros that each move calls.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "parser/flow/call.hpp"

namespace kerf::parser {

// Modal calls form a stack. A move calls the top one, a move inside that macro calls the one below
// it, and so on. G67 removes the top one.
class ModalCalls {
 public:
  static constexpr std::size_t kMax = 4;

  [[nodiscard]] bool any() const { return count_ > 0; }
  // False: the stack is full.
  bool add(Call call) {
    if (count_ == kMax) {
      return false;
    }
    calls_[count_++] = std::move(call);
    return true;
  }
  void cancel() { count_ -= count_ > 0 ? 1 : 0; }

  // The call of a move that is `depth` calls deep; nullptr: none is left.
  const Call* begin(std::size_t depth) {
    while (running_ > 0 && depth < running_at_[running_ - 1].depth) {
      --running_;  // that macro has returned
    }
    const std::size_t above = running_ > 0 ? running_at_[running_ - 1].call : count_;
    if (above == 0 || above > count_) {
      return nullptr;
    }
    running_at_[running_++] = {above - 1, depth + 1};
    return &calls_[above - 1];
  }

 private:
  struct Running {
    std::size_t call = 0;   // in calls_
    std::size_t depth = 0;  // of the macro's own lines
  };
  std::array<Call, kMax> calls_;
  std::size_t count_ = 0;
  std::array<Running, kMax> running_at_;  // each of a call beneath that of the one before
  std::size_t running_ = 0;
};

}  // namespace kerf::parser
