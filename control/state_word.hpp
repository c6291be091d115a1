// The state of a controller, which several threads change.
#pragma once

#include <atomic>
#include <cstdint>

#include <kerf/controller.hpp>

namespace kerf::control {

// A change counts only if the state is still the one that was seen, and has been it since: who
// waited, ran and waits again is in another state than before.
class StateWord {
 public:
  struct Seen {
    std::uint64_t word = 0;
    [[nodiscard]] ControllerState state() const noexcept {
      return static_cast<ControllerState>(word & kStateMask);
    }
    // There was a fault, and no reset since.
    [[nodiscard]] bool has_failed() const noexcept { return (word & kFailed) != 0; }
  };
  [[nodiscard]] Seen load() const noexcept { return {word_.load()}; }
  [[nodiscard]] ControllerState state() const noexcept { return load().state(); }
  // False: it is another one by now, and `from` says which.
  bool change(Seen& from, ControllerState to) noexcept {
    const bool fails =
        to == ControllerState::fault || (from.has_failed() && to != ControllerState::off);
    const std::uint64_t changes =
        (from.word & ~(kStateMask | kFailed)) + (from.state() != to ? kOneChange : 0);
    return word_.compare_exchange_strong(
        from.word, changes | (fails ? kFailed : 0) | static_cast<std::uint64_t>(to));
  }

 private:
  static constexpr std::uint64_t kStateMask = 0x7f;
  static constexpr std::uint64_t kFailed = 0x80;
  static constexpr std::uint64_t kOneChange = 0x100;
  std::atomic<std::uint64_t> word_{static_cast<std::uint64_t>(ControllerState::off)};
};

}  // namespace kerf::control
