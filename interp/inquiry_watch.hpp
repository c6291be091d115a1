// What the program asks the machine, from the planning side to the tick and back.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include <kerf/program_inputs.hpp>

#include "curves/position.hpp"
#include "profiles/cell_law.hpp"
#include "profiles/shape_value.hpp"

namespace kerf::interp {

using curves::Position;

// A question of a block of the program: of its motion, which ends where the probe says, and of the
// wait after it; or of that alone.
struct Inquiry {
  enum class Kind : std::uint8_t {
    contact,
    contact_end,
    digital,
    rise,
    fall,
    high,
    low,
    analog,
    at_speed
  };

  std::uint64_t block = 0;  // Phase::run_block of its motion, rest_block of its wait
  Kind kind = Kind::contact;
  std::size_t channel = 0;
  std::int64_t max_ticks = 0;     // that it waits for an input; for the spindle without end
  profiles::RampLimits limits{};  // of a probe's motion, along its line
  std::int64_t pause_ticks = 0;   // from the answer to the motion that follows it

  [[nodiscard]] bool is_probe() const noexcept { return kind <= Kind::contact_end; }
};

struct InquiryAnswer {
  bool found = false;
  bool at_start = false;
  double value = 0.0;
  Position place_mm{};
  Position rest_mm{};
  // The motion left its plan at a tick of the plan's time, along these laws, which make a plan of
  // that number; none: it was at rest.
  bool has_braked = false;
  std::int64_t brake_tick = 0;
  std::uint32_t plan = 0;
  std::size_t laws = 0;
  std::array<profiles::CellLaw, 3> law{};
  std::int64_t rest_tick = 0;  // of the plan's time
};

// One question at a time: ask() comes after the answer to the one before was read. ask(), answer()
// and ignore_probe() are for the planning thread, the rest for the thread of the tick.
class InquiryWatch {
 public:
  void ask(const Inquiry& inquiry) noexcept {
    inquiry_ = inquiry;
    asked_.fetch_add(1, std::memory_order_release);
  }
  // To the latest question; null: there is none yet, or nothing was asked.
  [[nodiscard]] const InquiryAnswer* answer() const noexcept {
    const std::uint32_t number = asked_.load(std::memory_order_relaxed);
    return number != 0 && answered_.load(std::memory_order_acquire) == number ? &answer_ : nullptr;
  }
  // The motion is to come to rest anyway.
  void ignore_probe() noexcept { ignores_.store(true, std::memory_order_relaxed); }

  void set_inputs(const ProgramInputs& inputs) noexcept { inputs_ = inputs; }
  // Null: nothing is asked.
  [[nodiscard]] const Inquiry* asked() noexcept;
  // A tick on the motion of a probe. True: it is to brake, and has not.
  [[nodiscard]] bool must_brake() noexcept;
  void brake(const InquiryAnswer& braked) noexcept;
  [[nodiscard]] bool has_braked() const noexcept { return found_.has_braked; }
  // A tick at rest after it. True: there is an answer now.
  [[nodiscard]] bool wait(const Position& rest_mm, std::int64_t plan_tick) noexcept;
  // The machine could have answered by now.
  [[nodiscard]] bool has_heard() const noexcept { return ticks_at_rest_ > 1; }

 private:
  [[nodiscard]] bool touches_as_asked() const noexcept {
    return inputs_.probe == (inquiry_.kind == Inquiry::Kind::contact);
  }
  void trip() noexcept;
  // True: the wait is over.
  [[nodiscard]] bool hears_input() noexcept;

  Inquiry inquiry_{};       // written before asked_ counts it
  InquiryAnswer answer_{};  // written before answered_ counts it
  std::atomic<std::uint32_t> asked_ = 0;
  std::atomic<std::uint32_t> answered_ = 0;
  std::atomic<bool> ignores_ = false;
  // Of the tick.
  ProgramInputs inputs_{};
  std::uint32_t begun_ = 0;  // the question that found_ is of
  InquiryAnswer found_{};
  bool moves_ = false;  // the motion of the probe has begun
  bool was_high_ = false;
  std::int64_t ticks_at_rest_ = 0;
};

}  // namespace kerf::interp
