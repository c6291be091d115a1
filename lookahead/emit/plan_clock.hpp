// The time at which planned motion begins.
#pragma once

#include <cstdint>

#include "interp/motion.hpp"

namespace kerf::lookahead {

// Counts whole ticks beside the rest of one, so that it does not wear out.
class PlanClock {
 public:
  explicit PlanClock(double period_s) : period_s_(period_s) {}

  [[nodiscard]] const interp::TickTime& now() const noexcept { return now_; }
  // The tick that is now, or the first one after it.
  [[nodiscard]] std::int64_t next_tick() const noexcept;

  // duration_s >= 0
  void advance(double duration_s) noexcept;
  // On to next_tick(), as after a rest.
  void align_to_tick() noexcept;

 private:
  double period_s_;
  interp::TickTime now_{};
};

}  // namespace kerf::lookahead
