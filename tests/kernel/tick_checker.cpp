#include "tests/kernel/tick_checker.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace kerf::test {

namespace {

// Positions are doubles of up to some 1e3 mm, s of up to 1e5: half a unit in the last place of each
// of the four values, as an acceleration and as a jerk.
constexpr double kRounding_mm = 1e-11;
constexpr double kRelative = 1e-6;

}  // namespace

const char* name_of(Figure figure) {
  constexpr std::array<const char*, kFigures> kNames{
      "feedrate",      "backward motion",   "path acceleration", "path jerk",
      "axis velocity", "axis acceleration", "axis jerk"};
  return kNames[static_cast<std::size_t>(figure)];
}

void TickChecker::add(const Tick& tick) {
  if (count_ == 0) {
    last_.fill(tick);
  }
  std::copy_backward(last_.begin(), last_.end() - 1, last_.end());
  last_[0] = tick;
  ++count_;
  judge_path();
  std::array<double, 4> x{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] = last_[i].setpoint.position_mm[k];
    }
    judge_axis(x, limits_.axes[k]);
  }
  for (std::size_t k = 0; k < curves::kAuxiliaryAxes; ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] = last_[i].setpoint.extra_rad_mm[k];
    }
    judge_axis(x, limits_.extra[k]);
  }
}

void TickChecker::judge_path() {
  const double ts = limits_.period_s;
  std::array<double, 4> s{};
  for (std::size_t i = 0; i < 4; ++i) {
    s[i] = last_[i].setpoint.s_mm;
  }
  judge(Figure::feedrate, (s[0] - s[1]) / ts,
        std::min(last_[0].feedrate_mm_s, limits_.path.velocity_mm_s));
  judge(Figure::backward_motion, (s[1] - s[0]) / ts, 0.0);
  judge(Figure::path_acceleration, std::abs(s[0] - 2.0 * s[1] + s[2]) / (ts * ts),
        limits_.path.acceleration_mm_s2);
  if (jerk_binds_) {
    judge(Figure::path_jerk, std::abs(s[0] - 3.0 * (s[1] - s[2]) - s[3]) / (ts * ts * ts),
          limits_.path.jerk_mm_s3);
  }
}

void TickChecker::judge_axis(const std::array<double, 4>& x, const lookahead::MotionLimits& limit) {
  const double ts = limits_.period_s;
  judge(Figure::axis_velocity, std::abs(x[0] - x[1]) / ts, limit.velocity_mm_s);
  judge(Figure::axis_acceleration, std::abs(x[0] - 2.0 * x[1] + x[2]) / (ts * ts),
        limit.acceleration_mm_s2);
  if (jerk_binds_) {
    judge(Figure::axis_jerk, std::abs(x[0] - 3.0 * (x[1] - x[2]) - x[3]) / (ts * ts * ts),
          limit.jerk_mm_s3);
  }
}

void TickChecker::judge(Figure figure, double found, double limit) {
  const double ts = limits_.period_s;
  const std::array<double, kFigures> time{ts, ts, ts * ts, ts * ts * ts, ts, ts * ts, ts * ts * ts};
  const auto number = static_cast<std::size_t>(figure);
  const double rounding = kRounding_mm / time[number];
  worst_[number] = std::max(worst_[number], found / (limit + rounding));
  if (complaint_.empty() && !(found <= limit * (1.0 + kRelative) + rounding)) {
    std::ostringstream text;
    text.precision(12);
    text << name_of(figure) << " " << found << " is above " << limit << " at tick "
         << last_[0].setpoint.tick << ", line " << last_[0].setpoint.line << ", s "
         << last_[0].setpoint.s_mm;
    complaint_ = text.str();
  }
}

}  // namespace kerf::test
