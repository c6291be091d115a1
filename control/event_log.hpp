// What happened, for any number of readers, without a lock.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <span>

#include <kerf/controller.hpp>

namespace kerf::control {

// An event is one word, so that any thread may write one and none is read torn. The word begins
// with the low bits of the event's number: a reader that finds others finds an event that is not
// written yet, or gone.
class EventLog {
 public:
  // Any thread.
  void note(ControllerEvent event) noexcept {
    event.number = next_number_.fetch_add(1);
    words_[event.number % kKept].store(word_of(event), std::memory_order_release);
  }
  // That the next event will have.
  [[nodiscard]] std::uint64_t next_number() const noexcept { return next_number_.load(); }

  // From that number on, as many as there is room for and are still kept. Returns how many.
  [[nodiscard]] std::size_t since(std::uint64_t number,
                                  std::span<ControllerEvent> events) const noexcept {
    const std::uint64_t end = next_number();
    std::uint64_t next = std::max(number, end > kKept ? end - kKept : 1);
    std::size_t found = 0;
    for (; next < end && found < events.size(); ++next) {
      const std::uint64_t word = words_[next % kKept].load(std::memory_order_acquire);
      if (word >> kNumberBit == (next & kNumberMask)) {
        events[found++] = event_of(word, next);
      } else if (next_number() <= next + kKept) {
        break;  // it is being written
      }
    }
    return found;
  }

 private:
  static constexpr std::size_t kKept = ControllerEvent::kKept;
  static constexpr unsigned kNumberBit = 48;
  static constexpr std::uint64_t kNumberMask = 0xffff;
  static constexpr unsigned kKindBit = 47;
  static constexpr unsigned kCauseBit = 44;
  static constexpr unsigned kWaitsBit = 40;
  static constexpr unsigned kStateBit = 32;

  static std::uint64_t word_of(const ControllerEvent& event) noexcept {
    return (event.number & kNumberMask) << kNumberBit |
           static_cast<std::uint64_t>(event.kind) << kKindBit |
           static_cast<std::uint64_t>(event.waits_for) << kWaitsBit |
           static_cast<std::uint64_t>(event.wait_cause) << kCauseBit |
           static_cast<std::uint64_t>(event.state) << kStateBit |
           (event.kind == ControllerEvent::Kind::message ? event.message : event.line);
  }
  static ControllerEvent event_of(std::uint64_t word, std::uint64_t number) noexcept {
    ControllerEvent event{.number = number,
                          .kind = static_cast<ControllerEvent::Kind>(word >> kKindBit & 1U),
                          .state = static_cast<ControllerState>(word >> kStateBit & 0xffU),
                          .waits_for = static_cast<WaitsFor>(word >> kWaitsBit & 0xfU),
                          .wait_cause = static_cast<WaitCause>(word >> kCauseBit & 0x7U)};
    (event.kind == ControllerEvent::Kind::message ? event.message : event.line) =
        static_cast<std::uint32_t>(word);
    return event;
  }

  std::atomic<std::uint64_t> next_number_ = 1;
  std::array<std::atomic<std::uint64_t>, kKept> words_{};
};

}  // namespace kerf::control
