#include "lookahead/optimum/grid/junction_share.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <optional>

#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

namespace {

// What they leave is for what the bounds on the cells do not see within three ticks of them.
constexpr std::array kShares{
    JumpShares{.jump = 0.25, .turn = 0.15, .cells = 0.59, .tangential = 1.0},
    JumpShares{.jump = 0.5, .turn = 0.1, .cells = 0.39, .tangential = 1.0},
    JumpShares{.jump = 0.95, .turn = 0.02, .cells = 0.02, .tangential = 0.02},
    JumpShares{.jump = 0.995, .turn = 0.001, .cells = 0.001, .tangential = 0.001}};
// Beside such a jump the motion is almost a cruise: it may be seen together with another one.
constexpr double kNearlyAll = 0.95;
// Of an axis' acceleration, which a jump of direction takes from the cells.
constexpr double kStepShare = 0.95;
constexpr double kAllShares = 0.99;
// Of a jump of curvature that its cells share at each feedrate: what both may use, how much of it a
// slight turn may take beside it, and what must be left to the cells.
constexpr double kDynamic = 0.998;
constexpr double kMaxOfTurn = 0.1;
constexpr double kMinDynamic = 0.75;
// Of the feedrate now, that at a junction just after it.
constexpr double kAtMostOfPassed = 2.0;
constexpr double kSmooth = 1e-9;    // of the path's feedrate and of further axes
constexpr double kStepPeak = 0.75;  // of a step of acceleration in a third difference

double limit_or_path(double axis, double path) {
  return std::isfinite(axis) ? axis : path;
}

// Calls use(|du|, limits of the axis) for every axis, and for the path.
template <typename Use>
void for_each_turn(const BlockEnd& before, const BlockEnd& after, const PlanLimits& limits,
                   Use use) {
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    use(std::abs(after.first[k] - before.first[k]), limits.axes[k]);
  }
  for (std::size_t k = 0; k < limits.extra.size(); ++k) {
    use(std::abs(after.extra_per_mm[k] - before.extra_per_mm[k]), limits.extra[k]);
  }
  use(path_step_of(before, after), limits.path);
}

// The limits with the share of the jump itself.
PlanLimits jump_limits(const PlanLimits& limits, const JumpShares& shares) {
  PlanLimits part = limits;
  const auto scale = [&shares](MotionLimits& of) {
    of.acceleration_mm_s2 *= kStepShare;
    of.jerk_mm_s3 *= shares.jump;
  };
  scale(part.path);
  std::for_each(part.axes.begin(), part.axes.end(), scale);
  std::for_each(part.extra.begin(), part.extra.end(), scale);
  return part;
}

JunctionLimits junction_limits_with(const Jump& jump, double feedrate_mm_s,
                                    const JumpShares& shares, const PlanLimits& limits) {
  JunctionLimits junction{.feedrate_mm_s = feedrate_mm_s, .shares = shares};
  double step = 0.0;
  for_each_turn(jump.before, jump.after, limits, [&](double turn, const MotionLimits& axis) {
    if (turn > 0.0) {
      const double jerk = limit_or_path(axis.jerk_mm_s3, limits.path.jerk_mm_s3);
      const double a = limit_or_path(axis.acceleration_mm_s2, limits.path.acceleration_mm_s2);
      junction.acceleration_mm_s2 = std::min(
          junction.acceleration_mm_s2, shares.turn * jerk * limits.period_s / (kStepPeak * turn));
      step = std::max(step, feedrate_mm_s * turn / (limits.period_s * a));
    }
  });
  junction.acceleration_share = kAllShares - std::min(step, kStepShare);
  return junction;
}

// A tick around a junction at which the feedrate is least is longer than at that feedrate, by
// J Ts^3 / 24 at the most. 0: a stop.
double chord_bound_mm_s(const JunctionQuery& query, const JumpShares& shares,
                        const PlanLimits& limits) {
  const BlockEnd& before = query.before->end;
  const BlockEnd& after = query.after->begin;
  const double chord = chord_feedrate_mm_s(before, after, limits);
  if (!std::isfinite(chord)) {
    return chord;
  }
  const auto jerk = [&limits](const Block& block, const BlockEnd& end) {
    return tangential_jerk_mm_s3(Cell{.along = block.along.ramp}, end, limits);
  };
  const double most =
      shares.cells * std::max(jerk(*query.before, before), jerk(*query.after, after));
  return std::max(chord - most * limits.period_s * limits.period_s / 24.0, 0.0);
}

// What curvature beside a jump allows with the jerk that is left to the cells.
double feedrate_beside_mm_s(const BlockEnd& before, const BlockEnd& after, const JumpShares& shares,
                            const PlanLimits& limits) {
  const double third = std::max(before.max_third_per_mm2, after.max_third_per_mm2);
  double jerk = limits.path.jerk_mm_s3;
  for (const MotionLimits& axis : limits.axes) {
    jerk = std::min(jerk, axis.jerk_mm_s3);
  }
  return third > 0.0 ? std::cbrt(shares.cells * jerk / third) : kUnbounded;
}

// The way of three ticks beside a junction, on a block.
double zone_mm(const Block& block, const BlockEnd& end, const JunctionLimits& junction,
               const PlanLimits& limits) {
  return zone_mm(Cell{.along = block.along.ramp}, end, junction, limits);
}

// Neither the path's own feedrate nor a further axis changes its direction.
bool is_smooth_beside_axes(const BlockEnd& before, const BlockEnd& after) {
  double turn = path_step_of(before, after);
  for (std::size_t k = 0; k < before.extra_per_mm.size(); ++k) {
    turn = std::max(turn, std::abs(after.extra_per_mm[k] - before.extra_per_mm[k]));
  }
  return turn <= kSmooth;
}

// The limits of a jump of curvature that its cells share by its size at each feedrate; what
// rounding of a program leaves of a turn has a fixed share. Nothing: the turn is more than that, or
// at its feedrate the feedrate changes too much within a tick.
//
// A third difference whose middle is off the jump by a share x of a tick sees x^2 4/3 less of it,
// while the feedrate there may be lower by a x Ts: what the cells take for the jump is short by
// 3/16 (2 a Ts / v)^2 of it at the most, and that is left free.
std::optional<JunctionLimits> dynamic_limits_of(const Jump& jump, const PlanLimits& limits) {
  const double ts = limits.period_s;
  std::array<MotionLimits, 3> axes = limits.axes;
  JunctionLimits junction{.feedrate_mm_s = jump.allowed_mm_s};
  double change_mm_s = 0.0;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    MotionLimits& axis = axes[k];
    axis.jerk_mm_s3 = limit_or_path(axis.jerk_mm_s3, limits.path.jerk_mm_s3);
    axis.acceleration_mm_s2 =
        limit_or_path(axis.acceleration_mm_s2, limits.path.acceleration_mm_s2);
    const double bend = std::abs(jump.after.second_per_mm[k] - jump.before.second_per_mm[k]);
    junction.jumps_per_mm_s[k] = kStepPeak * bend / ts;
    change_mm_s = std::max(change_mm_s, 2.0 * axis.acceleration_mm_s2 * ts);
    if (bend > 0.0) {
      junction.feedrate_mm_s =
          std::min(junction.feedrate_mm_s,
                   std::sqrt(kDynamic * axis.jerk_mm_s3 / junction.jumps_per_mm_s[k]));
    }
  }
  const double v = junction.feedrate_mm_s;
  double turn_share = 0.0;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const double turn = std::abs(jump.after.first[k] - jump.before.first[k]);
    const double a = axes[k].acceleration_mm_s2;
    turn_share = std::max({turn_share, turn * (v / ts + kStepPeak * a) / (ts * axes[k].jerk_mm_s3),
                           turn * v / (ts * a)});
  }
  const double change = change_mm_s / v;
  junction.acceleration_share = 1.0 - turn_share;
  junction.shares = {.turn = 1.0, .cells = kDynamic - turn_share - 3.0 / 16.0 * change * change};
  const bool holds = is_smooth_beside_axes(jump.before, jump.after) && turn_share <= kMaxOfTurn &&
                     junction.shares.cells >= kMinDynamic;
  return holds ? std::optional(junction) : std::nullopt;
}

}  // namespace

JunctionLimits junction_limits_of(const Jump& jump, const PlanLimits& limits) {
  if (const auto dynamic = dynamic_limits_of(jump, limits)) {
    return *dynamic;
  }
  JunctionLimits fastest;
  double max_mm_s = -1.0;
  for (const JumpShares& shares : kShares) {
    JumpShares of_one = shares;
    of_one.jump /= jump.crowd;
    const double corner =
        corner_feedrate_mm_s(jump.before, jump.after, jump_limits(limits, of_one));
    const JunctionLimits junction =
        junction_limits_with(jump, std::min(jump.allowed_mm_s, corner), shares, limits);
    if (corner >= jump.allowed_mm_s) {
      return junction;
    }
    const double passed_mm_s =
        std::min(corner, feedrate_beside_mm_s(jump.before, jump.after, shares, limits));
    if (passed_mm_s > max_mm_s) {
      max_mm_s = passed_mm_s;
      fastest = junction;
    }
  }
  return fastest;
}

namespace {

// Nothing: it stops there, more than curvature jumps, or a block is too short for the ticks that
// see it.
std::optional<CellJunction> dynamic_junction_of(const JunctionQuery& query,
                                                const PlanLimits& limits) {
  const Block& before = *query.before;
  const Block& after = *query.after;
  const Junction found = junction_of(query, limits);
  if (found.feedrate_mm_s == 0.0 || found.constant_velocity_s == 0.0) {
    return std::nullopt;
  }
  const auto junction = dynamic_limits_of(
      {.before = before.end,
       .after = after.begin,
       .allowed_mm_s = std::min({before.along.feedrate_mm_s, after.along.feedrate_mm_s,
                                 chord_bound_mm_s(query, {}, limits)})},
      limits);
  const bool fits = junction &&
                    zone_mm(before, before.end, *junction, limits) <= 0.5 * before.length_mm &&
                    zone_mm(after, after.begin, *junction, limits) <= 0.5 * after.length_mm;
  return fits ? std::optional(CellJunction{.limits = *junction}) : std::nullopt;
}

}  // namespace

CellJunction cell_junction_of(const JunctionQuery& query, const PlanLimits& limits) {
  const Block& before = *query.before;
  const Block& after = *query.after;
  if (after.continues && !before.stop_after) {
    return {.smooth = true, .limits = {.feedrate_mm_s = junction_of(query, limits).feedrate_mm_s}};
  }
  const Jump jump{.before = before.end, .after = after.begin};
  const double free_mm_s = junction_of(query, jump_limits(limits, {.jump = 1.0})).feedrate_mm_s;
  if (const auto dynamic = dynamic_junction_of(query, limits)) {
    return *dynamic;
  }
  CellJunction fastest;
  double max_mm_s = -1.0;
  for (const JumpShares& shares : kShares) {
    const double chord = chord_bound_mm_s(query, shares, limits);
    Junction found = junction_of(query, jump_limits(limits, shares));
    found.feedrate_mm_s = std::min(found.feedrate_mm_s, chord);
    const JunctionLimits junction = junction_limits_with(jump, found.feedrate_mm_s, shares, limits);
    const bool stops = found.feedrate_mm_s == 0.0;
    const CellJunction passed{.smooth = !stops && found.constant_velocity_s == 0.0,
                              .limits = junction};
    // Ways that overlap would let a third difference see two junctions.
    const bool fits = zone_mm(before, before.end, junction, limits) <= 0.5 * before.length_mm &&
                      zone_mm(after, after.begin, junction, limits) <= 0.5 * after.length_mm;
    if (fits && found.feedrate_mm_s >= std::min(free_mm_s, chord)) {
      return passed;
    }
    const double passed_mm_s = std::min(
        found.feedrate_mm_s, feedrate_beside_mm_s(jump.before, jump.after, shares, limits));
    if (shares.jump >= kNearlyAll && passed_mm_s > max_mm_s) {
      max_mm_s = passed_mm_s;
      fastest = passed;
    }
  }
  return fastest;
}

CellJunction passed_junction_of(const JunctionQuery& query, double v_mm_s,
                                const PlanLimits& limits) {
  const Jump jump{.before = query.before->end, .after = query.after->begin};
  const double v = kAtMostOfPassed * v_mm_s;
  const auto* const enough = std::ranges::find_if(kShares, [&](const JumpShares& shares) {
    return corner_feedrate_mm_s(jump.before, jump.after, jump_limits(limits, shares)) >= v;
  });
  const JumpShares& shares = enough == kShares.end() ? kShares.back() : *enough;
  return {.limits = junction_limits_with(jump, v, shares, limits)};
}

// With the largest share that leaves room for more than a cruise it could not be passed so fast.
bool passed_as_cruise(const JunctionQuery& query, double feedrate_mm_s, const PlanLimits& limits) {
  const auto* const most = std::ranges::find_if(
      kShares, [](const JumpShares& shares) { return shares.jump >= kNearlyAll; });
  const PlanLimits left = jump_limits(limits, *std::prev(most));
  return junction_of(query, left).feedrate_mm_s < feedrate_mm_s;
}

}  // namespace kerf::lookahead
