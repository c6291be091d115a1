// Judges ticks by finite differences of positions and of path length, as a drive sees them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "interp/setpoint.hpp"
#include "lookahead/limits.hpp"

namespace kerf::test {

class TickChecker {
 public:
  struct Tick {
    interp::Setpoint setpoint;
    double feedrate_mm_s = 0.0;  // the highest programmed of the blocks since the tick before
  };

  TickChecker(const lookahead::PlanLimits& limits, bool jerk_binds)
      : limits_(limits), jerk_binds_(jerk_binds) {}

  void add(const Tick& tick);
  // What was exceeded, where and by how much; empty if nothing was.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  [[nodiscard]] std::int64_t ticks() const { return count_; }

 private:
  void judge_path();
  void judge_axis(const std::array<double, 4>& x, const lookahead::MotionLimits& limit);
  void judge(const char* what, double found, double limit);

  lookahead::PlanLimits limits_;
  bool jerk_binds_;
  std::array<Tick, 4> last_{};  // newest first
  std::int64_t count_ = 0;
  std::string complaint_;
};

}  // namespace kerf::test
