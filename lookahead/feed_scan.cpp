#include "lookahead/feed_scan.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::lookahead {

using curves::NurbsCurve;
using curves::vec;

namespace {

constexpr int kChordPoints = 7;         // inside a tick
constexpr int kMaxAdjustments = 30;     // 2 to 4 are usual
constexpr double kLeastStep_mm = 1e-7;  // below any curve's features: keeps the walk finite
// What straight lines between samples may miss of the bound.
constexpr double kInside = 0.9998;
// The feedrate aims this far inside the tolerance, so that the adjustment ends.
constexpr double kAim = 0.9995;

double chord_error_mm(const NurbsCurve& curve, double s_from_mm, double step_mm) {
  const curves::Position from = curve.at(s_from_mm);
  const curves::Position to = curve.at(s_from_mm + step_mm);
  const Eigen::Vector3d chord = vec(to) - vec(from);
  const double squared = chord.squaredNorm();
  double worst = 0.0;
  for (int k = 1; k <= kChordPoints; ++k) {
    const curves::Position point = curve.at(s_from_mm + step_mm * k / (kChordPoints + 1));
    const Eigen::Vector3d offset = vec(point) - vec(from);
    const double share = squared > 0.0 ? std::clamp(offset.dot(chord) / squared, 0.0, 1.0) : 0.0;
    worst = std::max(worst, (offset - share * chord).squaredNorm());
  }
  return std::sqrt(worst);
}

// MATH section 5, closed form for a constant radius.
double curvature_bound_mm_s(const NurbsCurve& curve, double s_mm, const ScanLimits& limits) {
  const double curvature = vec(curve.derivatives_at(s_mm).second_per_mm).norm();
  const double d = limits.chord_tolerance_mm;
  if (curvature * d >= 1.0) {
    return 2.0 / (curvature * limits.period_s);  // a tick may span the whole circle
  }
  return curvature > 0.0 ? 2.0 / limits.period_s * std::sqrt(2.0 * d / curvature - d * d)
                         : limits.feedrate_mm_s;
}

double tick_bound_mm_s(const NurbsCurve& curve, double s_mm, const ScanLimits& limits) {
  if (!std::isfinite(limits.chord_tolerance_mm)) {
    return limits.feedrate_mm_s;
  }
  double v = std::min(limits.feedrate_mm_s, curvature_bound_mm_s(curve, s_mm, limits));
  for (int i = 0; i < kMaxAdjustments; ++i) {
    const double step = std::min(v * limits.period_s, curve.length_mm() - s_mm);
    const double error = chord_error_mm(curve, s_mm, step);
    if (error <= limits.chord_tolerance_mm) {
      break;
    }
    v = step / limits.period_s * std::sqrt(kAim * limits.chord_tolerance_mm / error);
  }
  return v;
}

void append(Ceiling& ceiling, const FeedSample& sample) {
  if (!ceiling.empty() && sample.s_mm <= ceiling.back().s_mm) {
    ceiling.back().v_mm_s = std::min(ceiling.back().v_mm_s, sample.v_mm_s);
  } else {
    ceiling.push_back(sample);
  }
}

}  // namespace

Ceiling scan_feedrate(const NurbsCurve& curve, const ScanLimits& limits) {
  const double length = curve.length_mm();
  const double half_tick = 0.5 * limits.period_s;
  const double slack = std::isfinite(limits.jerk_mm_s3)
                           ? limits.jerk_mm_s3 * limits.period_s * limits.period_s / 24.0
                           : 0.0;
  Ceiling ceiling;
  for (double s = 0.0; s < length;) {
    const double v = tick_bound_mm_s(curve, s, limits);
    const double allowed = v < limits.feedrate_mm_s ? kInside * std::max(v - slack, 0.9 * v) : v;
    const double middle = std::min(s + v * half_tick, length);
    const curves::NurbsPiece& piece = curve.pieces()[curve.piece_index(s)];
    if (ceiling.empty()) {
      ceiling.push_back({.u = piece.u_at(0.0), .s_mm = 0.0, .v_mm_s = allowed});
    }
    append(ceiling, {.u = curve.pieces()[curve.piece_index(middle)].u_at(middle),
                     .s_mm = middle,
                     .v_mm_s = allowed});
    const double step = std::min(v * half_tick, 0.25 * (piece.s_end_mm - piece.s_begin_mm));
    s += std::max(step, kLeastStep_mm);
  }
  if (ceiling.back().s_mm < length) {
    ceiling.push_back(
        {.u = curve.pieces().back().u_end, .s_mm = length, .v_mm_s = ceiling.back().v_mm_s});
  }
  return ceiling;
}

}  // namespace kerf::lookahead
