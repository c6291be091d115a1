#include "kernel/time_left.hpp"

#include <algorithm>

#include "kernel/least_time.hpp"

namespace kerf {

namespace {

// Before so much was run, the machine is taken to keep the feedrate.
constexpr double kJudgedFrom_s = 1.0;

}  // namespace

TimeLeft::TimeLeft(const lookahead::PlanLimits& limits, double nominal_s)
    : fastest_mm_s_(LeastTime::fastest_mm_s(limits)), whole_nominal_s_(nominal_s) {}

void TimeLeft::push(const lookahead::Block& block) {
  const double feedrate_mm_s = std::min(block.feedrate_mm_s, fastest_mm_s_);
  pushed_.path_mm += block.extra.alone ? 0.0 : block.length_mm;
  pushed_.nominal_s += block.length_mm / feedrate_mm_s;
  marks_.push_back(pushed_);
}

void TimeLeft::push_rest(double duration_s) {
  pushed_.nominal_s += duration_s;
  marks_.push_back(pushed_);
}

double TimeLeft::nominal_at_s(double path_mm) {
  while (!marks_.empty() && marks_.front().path_mm <= path_mm) {
    behind_ = marks_.front();
    marks_.pop_front();
  }
  if (marks_.empty()) {
    return behind_.nominal_s;
  }
  const Mark& next = marks_.front();
  const double share = (path_mm - behind_.path_mm) / (next.path_mm - behind_.path_mm);
  return behind_.nominal_s + std::max(share, 0.0) * (next.nominal_s - behind_.nominal_s);
}

void TimeLeft::follow(const ToolPlace& tool) {
  const double done_s = nominal_at_s(tool.path_mm);
  if (tool.feed_override > 0.0) {
    // No machine is faster than that: a tool that is has not come down to the override yet.
    expected_s_ += std::min((done_s - done_nominal_s_) / tool.feed_override,
                            std::max(tool.moved_s - tool_.moved_s, 0.0));
  }
  done_nominal_s_ = done_s;
  tool_ = tool;
}

std::optional<double> TimeLeft::left_s() const {
  if (!(whole_nominal_s_ > 0.0) || !(tool_.feed_override > 0.0)) {
    return std::nullopt;
  }
  const double left_s = std::max(whole_nominal_s_ - done_nominal_s_, 0.0) / tool_.feed_override;
  const bool is_judged = tool_.moved_s > kJudgedFrom_s && expected_s_ > 0.0;
  return left_s * (is_judged ? tool_.moved_s / expected_s_ : 1.0);
}

}  // namespace kerf
