#include "kernel/time_left.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/least_time.hpp"
#include "kernel/nominal_time.hpp"

namespace kerf {

namespace {

// Before so much was run, the machine is taken to keep the feedrate.
constexpr double kJudgedFrom_s = 1.0;
constexpr double kRounding_s = 1e-6;

}  // namespace

TimeLeft::TimeLeft(const lookahead::PlanLimits& limits, const std::optional<NominalTime>& nominal)
    : fastest_mm_s_(LeastTime::fastest_mm_s(limits)),
      extra_(limits.extra),
      is_known_(nominal.has_value()),
      not_pushed_(nominal.value_or(NominalTime{})) {}

// As LeastTime counts it.
void TimeLeft::push(const lookahead::Block& block) {
  const double machine_mm_s = block.extra.alone ? kUnbounded : fastest_mm_s_;
  double nominal_s = block.length_mm / std::min(block.feedrate_mm_s, machine_mm_s);
  for (std::size_t axis = 0; axis < extra_.size(); ++axis) {
    const double way = std::abs(block.extra.end_rad_mm[axis] - block.extra.begin_rad_mm[axis]);
    nominal_s = std::max(nominal_s, way / extra_[axis].velocity_mm_s);
  }
  NominalTime time;
  add_motion(time, nominal_s, block.rapid, block.follows);
  not_pushed_ = sum_of(not_pushed_, time, -1.0);
  if (block.extra.alone) {
    push_standing(nominal_s);
    return;
  }
  pushed_.path_mm += block.length_mm;
  pushed_.nominal = sum_of(pushed_.nominal, time);
  marks_.push_back(pushed_);
}

void TimeLeft::push_rest(const lookahead::RestTime& time) {
  not_pushed_.rest_s -= time.expected_s;
  push_standing(time.planned_s);
}

void TimeLeft::end() {
  not_pushed_ = {};
}

void TimeLeft::push_standing(double duration_s) {
  pushed_.nominal.rest_s += duration_s;
  marks_.push_back(pushed_);
}

void TimeLeft::end_path_at(double path_mm) {
  rest_to_run_s_ += pushed_.nominal.rest_s - behind_.nominal.rest_s;
  pushed_.path_mm = path_mm;
  behind_ = pushed_;
  marks_.clear();
  done_nominal_ = behind_.nominal;
}

void TimeLeft::reach(double path_mm) {
  while (!marks_.empty() && marks_.front().path_mm <= path_mm) {
    rest_to_run_s_ += marks_.front().nominal.rest_s - behind_.nominal.rest_s;
    behind_ = marks_.front();
    marks_.pop_front();
  }
  done_nominal_ = behind_.nominal;
  if (!marks_.empty()) {
    const Mark& next = marks_.front();
    const double share = (path_mm - behind_.path_mm) / (next.path_mm - behind_.path_mm);
    done_nominal_ =
        sum_of(done_nominal_, sum_of(next.nominal, behind_.nominal, -1.0), std::max(share, 0.0));
  }
}

void TimeLeft::follow(const ToolPlace& tool) {
  const NominalTime done_before = done_nominal_;
  reach(tool.path_mm);
  double passed_s = std::max(tool.moved_s - tool_.moved_s, 0.0);
  const double rested_s = std::min(rest_to_run_s_, passed_s);
  rest_to_run_s_ -= rested_s;
  passed_s -= rested_s;
  in_motion_s_ += passed_s;
  if (tool.overrides.feed > 0.0) {
    const NominalTime done = sum_of(done_nominal_, done_before, -1.0);
    // No machine is faster than that: a tool that is has not come down to the override yet.
    expected_s_ += std::min(motion_at_s(done, tool.overrides), passed_s);
  }
  tool_ = tool;
}

std::optional<double> TimeLeft::left_s() const {
  if (!is_known_ || !(tool_.overrides.feed > 0.0)) {
    return std::nullopt;
  }
  // By blends it may be less than was expected.
  const NominalTime left = sum_of(sum_of(not_pushed_, pushed_.nominal), done_nominal_, -1.0);
  if (tool_.feed_is_0 && held_by_feed_s(left) > kRounding_s) {
    return std::nullopt;
  }
  const bool is_judged = in_motion_s_ > kJudgedFrom_s && expected_s_ > 0.0;
  const double pace = is_judged ? in_motion_s_ / expected_s_ : 1.0;
  const double pushed_rest_s = rest_to_run_s_ + pushed_.nominal.rest_s - behind_.nominal.rest_s;
  return pace * std::max(motion_at_s(left, tool_.overrides), 0.0) + pushed_rest_s +
         std::max(not_pushed_.rest_s, 0.0);
}

}  // namespace kerf
