#include "bench/papers/in_motion.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include "curves/arc.hpp"
#include "curves/line.hpp"
#include "lookahead/path/block_builder.hpp"

namespace kerf::bench {

using lookahead::Block;

namespace {

constexpr double kRunIn_mm = 40.0;  // long enough for any law to come to 100 mm/s and to rest
constexpr double kSame_mm_s = 1e-6;

// The circle or line of the place, ending there (-1) or beginning there (1).
curves::Curve circle_at(const curves::PathDerivatives& place, int side) {
  const Eigen::Vector3d at = curves::vec(place.position_mm);
  const Eigen::Vector3d bend = curves::vec(place.second_per_mm);
  const Eigen::Vector3d other = at + side * kRunIn_mm * curves::vec(place.first);
  if (bend.norm() * kRunIn_mm < 1e-6) {
    const auto line = side < 0
                          ? curves::Line::between(curves::to_position(other), place.position_mm)
                          : curves::Line::between(place.position_mm, curves::to_position(other));
    return *line;
  }
  const Eigen::Vector3d centre = at + bend / bend.squaredNorm();
  const bool clockwise =
      place.first[0] * place.second_per_mm[1] - place.first[1] * place.second_per_mm[0] < 0.0;
  const auto arc = curves::Arc::make({.start_mm = place.position_mm,
                                      .end_mm = place.position_mm,
                                      .centre_mm = curves::to_position(centre),
                                      .clockwise = clockwise});
  const double length = arc->length_mm();
  if (length <= kRunIn_mm) {
    return *arc;
  }
  return side < 0 ? arc->part({.begin_mm = length - kRunIn_mm, .end_mm = length})
                  : arc->part({.begin_mm = 0.0, .end_mm = kRunIn_mm});
}

Block block_on(curves::Curve curve, double feedrate_mm_s, const lookahead::PlanLimits& limits) {
  smoothing::PathSegment segment{.curve = std::move(curve), .feedrate_mm_s = feedrate_mm_s};
  if (std::holds_alternative<curves::Arc>(segment.curve)) {
    segment.arc_normal = 2;
  }
  auto block = lookahead::block_of(std::move(segment), limits);
  if (!block) {
    throw std::runtime_error(block.error().message);
  }
  return *std::move(block);
}

}  // namespace

double MotionRun::feedrate_mm_s(double u) const {
  const double s = std::get<curves::NurbsCurve>(block.curve).s_at(u);
  const auto after = std::ranges::lower_bound(
      on_curve, s, {}, [](const TickOfRun& tick) { return tick.setpoint.s_mm; });
  if (after == on_curve.begin() || after == on_curve.end()) {
    throw std::runtime_error("no tick there");
  }
  const Setpoint& b = after->setpoint;
  const Setpoint& a = std::prev(after)->setpoint;
  return a.v_mm_s + (b.v_mm_s - a.v_mm_s) * (s - a.s_mm) / (b.s_mm - a.s_mm);
}

double MotionRun::first_stretch_mm(double feedrate_mm_s) const {
  const auto slower = std::ranges::find_if(on_curve, [&](const TickOfRun& tick) {
    return tick.setpoint.v_mm_s < feedrate_mm_s - kSame_mm_s;
  });
  return slower == on_curve.begin() ? 0.0 : std::prev(slower)->setpoint.s_mm;
}

double MotionRun::last_stretch_mm(double feedrate_mm_s) const {
  const auto slower = std::find_if(on_curve.rbegin(), on_curve.rend(), [&](const TickOfRun& tick) {
    return tick.setpoint.v_mm_s < feedrate_mm_s - kSame_mm_s;
  });
  return slower == on_curve.rbegin() ? 0.0 : block.length_mm - std::prev(slower)->setpoint.s_mm;
}

bool keeps(const MotionRun& run, const lookahead::PlanLimits& limits,
           const PublishedLimits& published) {
  constexpr double kRounding = 1e-5;
  const lookahead::MotionLimits& path = published.path;
  const bool has_them = limits.path.velocity_mm_s == path.velocity_mm_s &&
                        limits.path.acceleration_mm_s2 == path.acceleration_mm_s2 &&
                        limits.path.jerk_mm_s3 == path.jerk_mm_s3 &&
                        limits.chord_tolerance_mm == published.chord_error_mm;
  const auto within = [](double figure, double limit) {
    return figure <= limit * (1.0 + kRounding);
  };
  return has_them && within(run.path.v_mm_s, path.velocity_mm_s) &&
         within(run.path.a_mm_s2, path.acceleration_mm_s2) &&
         within(run.path.j_mm_s3, path.jerk_mm_s3) &&
         within(run.chord_error_mm, published.chord_error_mm);
}

MotionRun in_motion(const std::string& program, const lookahead::PlanLimits& limits,
                    const profiles::Profile& profile) {
  MotionRun found{.block = curve_block(program, limits)};
  Block& curve = found.block;
  const double feedrate = curve.feedrate_mm_s;
  const Block before = block_on(circle_at(curve.begin, -1), feedrate, limits);
  Block after = block_on(circle_at(curve.end, 1), feedrate, limits);
  curve.continues = after.continues = true;
  const PlannedRun run = plan_of({before, curve, after}, limits, profile);
  for (const interp::Phase& phase : run.phases) {
    found.time_s += phase.curve == 2 ? phase.law.duration_s() : 0.0;
  }
  TickJudge judge({.limits = limits});
  judge.starve();  // the curve begins in motion
  for (TickOfRun tick : run.ticks) {
    tick.setpoint.s_mm -= before.length_mm;
    if (tick.setpoint.s_mm >= 0.0 && tick.setpoint.s_mm < curve.length_mm) {
      judge.add(tick.setpoint, found.on_curve.empty() ? 0.0 : tick.chord_error_mm);
      found.on_curve.push_back(tick);
    }
  }
  found.ticks = found.on_curve.size();
  found.path = judge.path();
  found.chord_error_mm = judge.chord_error_mm();
  return found;
}

}  // namespace kerf::bench
