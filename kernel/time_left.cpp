#include "kernel/time_left.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/least_time.hpp"

namespace kerf {

namespace {

// Before so much was run, the machine is taken to keep the feedrate.
constexpr double kJudgedFrom_s = 1.0;

}  // namespace

TimeLeft::TimeLeft(const lookahead::PlanLimits& limits, const std::optional<NominalTime>& nominal)
    : fastest_mm_s_(LeastTime::fastest_mm_s(limits)),
      extra_(limits.extra),
      is_known_(nominal.has_value()) {
  if (nominal) {
    not_pushed_ = {.fed_s = nominal->motion_s - nominal->rapid_s - nominal->steady_s,
                   .rapid_s = nominal->rapid_s,
                   .steady_s = nominal->steady_s};
    rest_not_pushed_s_ = nominal->rest_s;
  }
}

TimeLeft::MotionTime TimeLeft::MotionTime::plus(const MotionTime& other, double share) const {
  return {.fed_s = fed_s + share * other.fed_s,
          .rapid_s = rapid_s + share * other.rapid_s,
          .steady_s = steady_s + share * other.steady_s};
}

double TimeLeft::MotionTime::at_s(const ToolPlace& tool) const {
  return fed_s / tool.feed_override + rapid_s / tool.rapid_override + steady_s;
}

// As LeastTime counts it.
void TimeLeft::push(const lookahead::Block& block) {
  const double machine_mm_s = block.extra.alone ? kUnbounded : fastest_mm_s_;
  double nominal_s = block.length_mm / std::min(block.feedrate_mm_s, machine_mm_s);
  for (std::size_t axis = 0; axis < extra_.size(); ++axis) {
    const double way = std::abs(block.extra.end_rad_mm[axis] - block.extra.begin_rad_mm[axis]);
    nominal_s = std::max(nominal_s, way / extra_[axis].velocity_mm_s);
  }
  MotionTime time;
  (block.rapid ? time.rapid_s : block.follows.feed ? time.fed_s : time.steady_s) = nominal_s;
  not_pushed_ = not_pushed_.plus(time, -1.0);
  if (block.extra.alone) {
    push_standing(nominal_s);
    return;
  }
  pushed_.path_mm += block.length_mm;
  pushed_.nominal = pushed_.nominal.plus(time);
  marks_.push_back(pushed_);
}

void TimeLeft::push_rest(const lookahead::RestTime& time) {
  rest_not_pushed_s_ -= time.expected_s;
  push_standing(time.planned_s);
}

void TimeLeft::end() {
  not_pushed_ = {};
  rest_not_pushed_s_ = 0.0;
}

void TimeLeft::push_standing(double duration_s) {
  pushed_.rest_s += duration_s;
  marks_.push_back(pushed_);
}

void TimeLeft::end_path_at(double path_mm) {
  rest_to_run_s_ += pushed_.rest_s - behind_.rest_s;
  pushed_.path_mm = path_mm;
  behind_ = pushed_;
  marks_.clear();
  done_nominal_ = behind_.nominal;
}

void TimeLeft::reach(double path_mm) {
  while (!marks_.empty() && marks_.front().path_mm <= path_mm) {
    rest_to_run_s_ += marks_.front().rest_s - behind_.rest_s;
    behind_ = marks_.front();
    marks_.pop_front();
  }
  done_nominal_ = behind_.nominal;
  if (!marks_.empty()) {
    const Mark& next = marks_.front();
    const double share = (path_mm - behind_.path_mm) / (next.path_mm - behind_.path_mm);
    done_nominal_ =
        done_nominal_.plus(next.nominal.plus(behind_.nominal, -1.0), std::max(share, 0.0));
  }
}

void TimeLeft::follow(const ToolPlace& tool) {
  const MotionTime done_before = done_nominal_;
  reach(tool.path_mm);
  double passed_s = std::max(tool.moved_s - tool_.moved_s, 0.0);
  const double rested_s = std::min(rest_to_run_s_, passed_s);
  rest_to_run_s_ -= rested_s;
  passed_s -= rested_s;
  in_motion_s_ += passed_s;
  if (tool.feed_override > 0.0) {
    // No machine is faster than that: a tool that is has not come down to the override yet.
    expected_s_ += std::min(done_nominal_.plus(done_before, -1.0).at_s(tool), passed_s);
  }
  tool_ = tool;
}

std::optional<double> TimeLeft::left_s() const {
  if (!is_known_ || !(tool_.feed_override > 0.0)) {
    return std::nullopt;
  }
  // By blends it may be less than was expected.
  const MotionTime left = not_pushed_.plus(pushed_.nominal).plus(done_nominal_, -1.0);
  const bool is_judged = in_motion_s_ > kJudgedFrom_s && expected_s_ > 0.0;
  const double pace = is_judged ? in_motion_s_ / expected_s_ : 1.0;
  const double pushed_rest_s = rest_to_run_s_ + pushed_.rest_s - behind_.rest_s;
  return pace * std::max(left.at_s(tool_), 0.0) + pushed_rest_s + std::max(rest_not_pushed_s_, 0.0);
}

}  // namespace kerf
