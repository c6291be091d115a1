#include "lookahead/optimum/joint_share.hpp"

#include <algorithm>
#include <cmath>

#include "lookahead/optimum/speed_estimate.hpp"

namespace kerf::lookahead {

namespace {

// A jump allows a feedrate in proportion to its share, while the motion beside it is almost a
// cruise anyway: nearly all of the limits go to the jump. A hundredth is left for what the bounds
// on the cells do not see within three ticks of them.
constexpr double kJumpShare = 0.89;
constexpr double kTurnShare = 0.05;
constexpr double kCellShare = 0.05;
constexpr double kSupportTicks = 3.0;  // of a third difference
constexpr double kStepPeak = 0.75;     // of a step of acceleration in a third difference

// The acceleration along the path whose turn by |du| is seen as its share of the jerk.
double turned_acceleration_mm_s2(double turn, const MotionLimits& axis, double path_jerk_mm_s3,
                                 double period_s) {
  const double jerk = std::isfinite(axis.jerk_mm_s3) ? axis.jerk_mm_s3 : path_jerk_mm_s3;
  return turn > 0.0 ? kTurnShare * jerk * period_s / (kStepPeak * turn) : kUnbounded;
}

}  // namespace

PlanLimits jump_limits(const PlanLimits& limits) {
  PlanLimits part = limits;
  const auto scale = [](MotionLimits& of) {
    of.acceleration_mm_s2 *= kJumpShare;
    of.jerk_mm_s3 *= kJumpShare;
  };
  scale(part.path);
  std::for_each(part.axes.begin(), part.axes.end(), scale);
  std::for_each(part.extra.begin(), part.extra.end(), scale);
  return part;
}

Joint joint_of(const JunctionQuery& query, const PlanLimits& limits) {
  Joint joint{.passing = junction(query, jump_limits(limits))};
  const BlockEnd& before = query.before->end;
  const BlockEnd& after = query.after->begin;
  const auto bind = [&](double turn, const MotionLimits& axis) {
    joint.acceleration_mm_s2 = std::min(
        joint.acceleration_mm_s2,
        turned_acceleration_mm_s2(std::abs(turn), axis, limits.path.jerk_mm_s3, limits.period_s));
  };
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    bind(after.tangent[k] - before.tangent[k], limits.axes[k]);
  }
  for (std::size_t k = 0; k < limits.extra.size(); ++k) {
    bind(after.extra_per_mm[k] - before.extra_per_mm[k], limits.extra[k]);
  }
  bind(path_step_of(before, after), limits.path);
  return joint;
}

namespace {

// The way of three ticks from the jump, at the most: it may be sped up by what is left of the
// limits.
double zone_mm(const Cell& cell, const CellEnd& end, const PassedJump& jump,
               const PlanLimits& limits) {
  const double t = kSupportTicks * limits.period_s;
  const double a = kCellShare * tangential_acceleration_mm_s2(cell, end, limits);
  const double j = kCellShare * tangential_jerk_mm_s3(cell, end, limits);
  return t * (jump.feedrate_mm_s + t * (a + 0.5 * t * j));
}

}  // namespace

void share_limits(std::vector<Cell>& cells, const PassedJump& jump, const PlanLimits& limits) {
  const auto leave_rest = [](Cell& cell) {
    cell.allowed = kCellShare;
    cell.shares.acceleration = cell.shares.jerk = kAim * kCellShare;
    return cell.length_mm;
  };
  // The share taken off again: the cap holds whatever the share.
  const auto bind_acceleration = [&jump](Cell& cell) {
    double& a = cell.along.acceleration_mm_s2;
    a = std::min(a, jump.acceleration_mm_s2 / kCellShare);
  };
  if (jump.boundary > 0) {
    Cell& last = cells[jump.boundary - 1];
    last.end.bind_feedrate(jump.feedrate_mm_s, SpeedLimit::joint);
    bind_acceleration(last);
    const double zone = zone_mm(last, last.end, jump, limits);
    double way = 0.0;
    for (std::size_t i = jump.boundary; i-- > 0 && way < zone;) {
      way += leave_rest(cells[i]);
    }
  }
  if (jump.boundary < cells.size()) {
    Cell& first = cells[jump.boundary];
    first.begin.bind_feedrate(jump.feedrate_mm_s, SpeedLimit::joint);
    bind_acceleration(first);
    const double zone = zone_mm(first, first.begin, jump, limits);
    double way = 0.0;
    for (std::size_t i = jump.boundary; i < cells.size() && way < zone; ++i) {
      way += leave_rest(cells[i]);
    }
  }
}

}  // namespace kerf::lookahead
