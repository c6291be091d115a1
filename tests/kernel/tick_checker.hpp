// Judges ticks by finite differences of positions and of path length, as a drive sees them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "interp/setpoint.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::test {

// What has a limit.
enum class Figure : std::uint8_t {
  feedrate,
  backward_motion,
  path_acceleration,
  path_jerk,
  axis_velocity,
  axis_acceleration,
  axis_jerk,
};
inline constexpr std::size_t kFigures = 7;
const char* name_of(Figure figure);

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
  // The largest of each figure over what is allowed, by number of Figure.
  [[nodiscard]] const std::array<double, kFigures>& worst() const { return worst_; }

 private:
  void judge_path();
  void judge_axis(const std::array<double, 4>& x, const lookahead::MotionLimits& limit);
  void judge(Figure figure, double found, double limit);

  lookahead::PlanLimits limits_;
  bool jerk_binds_;
  std::array<Tick, 4> last_{};  // newest first
  std::int64_t count_ = 0;
  std::array<double, kFigures> worst_{};
  std::string complaint_;
};

}  // namespace kerf::test
