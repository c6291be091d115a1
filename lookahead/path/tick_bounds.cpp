#include <algorithm>
#include <cmath>

#include "lookahead/path/feed_scan.hpp"

namespace kerf::lookahead {

using curves::NurbsCurve;
using curves::vec;

namespace {

constexpr int kMaxAdjustments = 30;
// The error of a needle's tip is the same however far behind it a tick ends: where less than this
// is gained of what is too much, after as many adjustments as are usual, half of the feedrate is
// left. Close before a sharp turn the bound may be half of what fits, therefore.
constexpr int kUsualAdjustments = 4;
constexpr double kMinGain = 0.25;
constexpr double kMaxLeft = 0.5;
// Keep the walk finite. Steps are shorter than the first only where a tick is, too (at a cusp, with
// a tolerance of that size), but no less than these shares: of the tolerance, which no tick that
// matters is less than, and of the way to the curve's begin, before which all is continued.
constexpr double kMinStep_mm = 1e-7;
constexpr double kMinStepOfTolerance = 0.25;
constexpr double kMinStepBefore = 0.25;
// A bound that lies this share below the line of its neighbours is looked at more closely around,
// each time at half the distance: the line's own excess is a quarter of it at the most.
constexpr double kConvex = 4e-4;
constexpr int kRefinements = 6;
// Where curvature allows this many times the feedrate, this share of a quarter piece will do
// however short a tick is: at a very low feedrate the walk would never end.
constexpr double kFarBelow = 8.0;
constexpr double kFineShare = 1.0 / 64.0;
// Where curvature allows this many times the feedrate all over a quarter piece, and all over the
// tick that begins at its end, its chord errors are a quarter of the tolerance: no tick needs to be
// looked at, and it is passed in one step, whatever a tick is.
constexpr double kNearlyStraight = 2.0;
constexpr std::size_t kMaxPieces = 4;
constexpr int kStraightParts = 4;
// The feedrate aims this far inside the tolerance, so that the adjustment ends.
constexpr double kAim = 0.9995;

// docs/math.md, 4.1, closed form for a constant radius. Never less than the tolerance in a tick: no
// point of a way is farther than half of it from the nearer one of its ends, so even twice as much
// is no chord error whatever the turn. The half is kept free, for a tick around the turn is bound
// by lines between those that begin before it and at it.
double curvature_bound_mm_s(const NurbsCurve& curve, double s_mm, const ScanLimits& limits) {
  const double curvature = vec(curve.derivatives_at(s_mm).second_per_mm).norm();
  const double d = limits.chord_tolerance_mm;
  if (curvature * d >= 1.0) {
    return std::max(2.0 / curvature, d) / limits.period_s;  // it may segment the whole circle
  }
  return curvature > 0.0 ? 2.0 / limits.period_s * std::sqrt(2.0 * d / curvature - d * d)
                         : kUnbounded;
}

double tick_bound_mm_s(const ContinuedCurve& path, double s_mm, const ScanLimits& limits) {
  const NurbsCurve& curve = path.curve();
  if (!std::isfinite(limits.chord_tolerance_mm)) {
    return limits.feedrate_mm_s;
  }
  double v = curvature_bound_mm_s(curve, std::max(s_mm, 0.0), limits);
  if (s_mm + v * limits.period_s > curve.length_mm()) {
    v = std::max(v, curvature_bound_mm_s(curve, curve.length_mm(), limits));
  }
  v = std::min(v, limits.feedrate_mm_s);
  double error_before = 0.0;
  for (int i = 0; i < kMaxAdjustments; ++i) {
    const double step = std::min(v * limits.period_s, 2.0 * curve.length_mm() - s_mm);
    const double error = chord_error_mm(path, {.begin_mm = s_mm, .end_mm = s_mm + step});
    if (error <= limits.chord_tolerance_mm) {
      break;
    }
    const double aim = kAim * limits.chord_tolerance_mm;
    const bool is_stuck =
        i >= kUsualAdjustments && error_before - error < kMinGain * (error_before - aim);
    v = step / limits.period_s * (is_stuck ? kMaxLeft : std::sqrt(aim / error));
    error_before = error;
  }
  return v;
}

// Looked at piece by piece, for pieces are short where a curve turns sharply.
bool is_nearly_straight(const NurbsCurve& curve, double s_mm, double way_mm,
                        const ScanLimits& limits) {
  const double least = kNearlyStraight * limits.feedrate_mm_s;
  const std::size_t first = curve.piece_index(s_mm);
  const std::size_t last = curve.piece_index(s_mm + way_mm);
  if (last - first >= kMaxPieces) {
    return false;
  }
  for (std::size_t k = first; k <= last; ++k) {
    const curves::NurbsPiece& piece = curve.pieces()[k];
    const double begin = std::max(s_mm, piece.s_begin_mm);
    const double way = std::min(s_mm + way_mm, piece.s_end_mm) - begin;
    for (int i = 0; i <= kStraightParts; ++i) {
      if (!(curvature_bound_mm_s(curve, begin + way * i / kStraightParts, limits) > least)) {
        return false;
      }
    }
  }
  return true;
}

const curves::NurbsPiece& piece_at(const NurbsCurve& curve, double s_mm) {
  return curve.pieces()[curve.piece_index(s_mm)];
}

double quarter_mm(const curves::NurbsPiece& piece) {
  return 0.25 * (piece.s_end_mm - piece.s_begin_mm);
}

bool strides_from(const NurbsCurve& curve, double s_mm, const ScanLimits& limits) {
  return limits.plan == ScanFor::time_optimum && s_mm >= 0.0 &&
         is_nearly_straight(
             curve, s_mm,
             quarter_mm(piece_at(curve, s_mm)) + limits.feedrate_mm_s * limits.period_s, limits);
}

double half_tick_mm(const TickBound& at, const ScanLimits& limits) {
  return 0.5 * at.v_mm_s * limits.period_s;
}

double least_step_mm(const TickBound& at, const ScanLimits& limits) {
  return std::min(kMinStep_mm, std::max({half_tick_mm(at, limits),
                                         kMinStepOfTolerance * limits.chord_tolerance_mm,
                                         -kMinStepBefore * at.s_mm}));
}

// To the next place that is looked at.
double step_mm(const NurbsCurve& curve, const TickBound& at, bool strides,
               const ScanLimits& limits) {
  const double half_tick = half_tick_mm(at, limits);
  const double least = least_step_mm(at, limits);
  if (at.s_mm < 0.0) {
    return std::max(std::min(half_tick, -at.s_mm), least);
  }
  const curves::NurbsPiece& piece = piece_at(curve, at.s_mm);
  const double coarse = quarter_mm(piece);
  double step = half_tick;
  if (step < kFineShare * coarse &&
      curvature_bound_mm_s(curve, at.s_mm, limits) > kFarBelow * limits.feedrate_mm_s) {
    step = kFineShare * coarse;
  }
  step = std::max(strides ? coarse : std::min(step, coarse), least);
  // Pieces after may be much shorter.
  const bool passes_over_one = curve.piece_index(at.s_mm + step) > curve.piece_index(at.s_mm) + 1;
  return passes_over_one ? std::max(piece.s_end_mm - at.s_mm, least) : step;
}

// From so far before the curve that its begin is not before the middle of a tick.
std::vector<TickBound> walk(const ContinuedCurve& path, const ScanLimits& limits) {
  const NurbsCurve& curve = path.curve();
  const double length = curve.length_mm();
  std::vector<TickBound> bounds;
  for (double s = -std::min(0.5 * limits.feedrate_mm_s * limits.period_s, length); s < length;) {
    const bool strides = strides_from(curve, s, limits);
    bounds.push_back(
        {.s_mm = s, .v_mm_s = strides ? limits.feedrate_mm_s : tick_bound_mm_s(path, s, limits)});
    s += step_mm(curve, bounds.back(), strides, limits);
  }
  return bounds;
}

bool is_convex(const TickBound& before, const TickBound& at, const TickBound& after) {
  const double share = (at.s_mm - before.s_mm) / (after.s_mm - before.s_mm);
  const double line = before.v_mm_s + share * (after.v_mm_s - before.v_mm_s);
  return line - at.v_mm_s > kConvex * at.v_mm_s;
}

// True: there are more of them now.
bool refine(std::vector<TickBound>& bounds, const ContinuedCurve& path, const ScanLimits& limits) {
  std::vector<TickBound> finer;
  bool convex = false;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const bool convex_before = convex;
    convex = i > 0 && i + 1 < bounds.size() && is_convex(bounds[i - 1], bounds[i], bounds[i + 1]);
    if (i > 0 && (convex || convex_before) &&
        bounds[i].s_mm - bounds[i - 1].s_mm > 2.0 * least_step_mm(bounds[i], limits)) {
      const double middle = 0.5 * (bounds[i - 1].s_mm + bounds[i].s_mm);
      finer.push_back({.s_mm = middle, .v_mm_s = tick_bound_mm_s(path, middle, limits)});
    }
    finer.push_back(bounds[i]);
  }
  const bool more = finer.size() > bounds.size();
  bounds = std::move(finer);
  return more;
}

}  // namespace

std::vector<TickBound> tick_bounds(const NurbsCurve& curve, const ScanLimits& limits) {
  const ContinuedCurve path(curve);
  std::vector<TickBound> bounds = walk(path, limits);
  for (int i = 0; i < kRefinements && refine(bounds, path, limits); ++i) {
  }
  return bounds;
}

}  // namespace kerf::lookahead
