#include "lookahead/tick_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::lookahead {

using curves::NurbsCurve;
using curves::vec;

namespace {

constexpr int kChordPoints = 7;  // inside a tick
constexpr int kMaxAdjustments = 30;
// The error of a needle's tip is the same however far behind it a tick ends: after as many
// adjustments as are usual no more than this is left of it. Close before a sharp turn the bound may
// be half of what fits, therefore, and jumps from place to place.
constexpr int kUsualAdjustments = 4;
constexpr double kMostLeft = 0.5;
constexpr double kLeastStep_mm = 1e-7;  // below usual tolerances: keeps the walk finite
// A bound that lies this share below the line of its neighbours is looked at more closely around,
// each time at half the distance: the line's own excess is a quarter of it at the most.
constexpr double kConvex = 4e-4;
constexpr int kRefinements = 6;
// Where curvature allows this many times the feedrate, this share of a quarter piece will do
// however short a tick is: at a very low feedrate the walk would never end.
constexpr double kFarBelow = 8.0;
constexpr double kFineShare = 1.0 / 64.0;
// Where curvature allows this many times the feedrate all over a quarter piece, and all over the
// tick that begins at its end, its chord errors are a quarter of the tolerance: it is passed in one
// step, whatever a tick is.
constexpr double kNearlyStraight = 2.0;
constexpr std::size_t kMostPieces = 4;
constexpr int kStraightParts = 4;
// A piece is one of the sharpest if a neighbour is this many times as long and none is shorter, but
// for rounding: pieces are halved towards a needle, and even knots have none.
constexpr double kClearlyLonger = 1.5;
constexpr double kRounding = 1.0 + 1e-6;
// The feedrate aims this far inside the tolerance, so that the adjustment ends.
constexpr double kAim = 0.9995;

// The largest distance from a chord of the points looked at.
class ChordError {
 public:
  ChordError(const NurbsCurve& curve, double s_from_mm, double step_mm)
      : curve_(curve),
        s_from_mm_(s_from_mm),
        step_mm_(step_mm),
        from_(vec(curve.at(s_from_mm))),
        chord_(vec(curve.at(s_from_mm + step_mm)) - from_),
        chord_mm2_(chord_.squaredNorm()) {}

  void look(double share) {
    const Eigen::Vector3d offset = vec(curve_.at(s_from_mm_ + step_mm_ * share)) - from_;
    const double along =
        chord_mm2_ > 0.0 ? std::clamp(offset.dot(chord_) / chord_mm2_, 0.0, 1.0) : 0.0;
    const double squared_mm2 = (offset - along * chord_).squaredNorm();
    if (squared_mm2 > worst_mm2_) {
      worst_mm2_ = squared_mm2;
      worst_share_ = share;
    }
  }

  // The ends of the sharpest pieces: of a needle, of a hook.
  void look_at_sharpest() {
    const std::vector<curves::NurbsPiece>& pieces = curve_.pieces();
    const auto length = [&](std::size_t k) { return pieces[k].s_end_mm - pieces[k].s_begin_mm; };
    const double s_to_mm = s_from_mm_ + step_mm_;
    const std::size_t last = std::min(curve_.piece_index(s_to_mm) + 1, pieces.size() - 1);
    for (std::size_t k = std::max<std::size_t>(curve_.piece_index(s_from_mm_), 1); k < last; ++k) {
      const auto [shorter, longer] = std::minmax({length(k - 1), length(k + 1)});
      if (length(k) <= kRounding * shorter && kClearlyLonger * length(k) <= longer) {
        for (const double s_mm : {pieces[k].s_begin_mm, pieces[k].s_end_mm}) {
          if (s_mm > s_from_mm_ && s_mm < s_to_mm) {
            look((s_mm - s_from_mm_) / step_mm_);
          }
        }
      }
    }
  }

  [[nodiscard]] double worst_share() const { return worst_share_; }
  [[nodiscard]] double worst_mm() const { return std::sqrt(worst_mm2_); }

 private:
  const NurbsCurve& curve_;
  double s_from_mm_;
  double step_mm_;
  Eigen::Vector3d from_;
  Eigen::Vector3d chord_;
  double chord_mm2_;
  double worst_mm2_ = 0.0;
  double worst_share_ = 0.5;
};

// The farthest of kChordPoints points of the tick, then of those half and a quarter of their
// distance beside it; and of those where the curve is sharpest, which may all lie between them.
double chord_error_mm(const NurbsCurve& curve, double s_from_mm, double step_mm) {
  ChordError error(curve, s_from_mm, step_mm);
  constexpr double kApart = 1.0 / (kChordPoints + 1);
  for (int k = 1; k <= kChordPoints; ++k) {
    error.look(kApart * k);
  }
  for (const double beside : {0.5 * kApart, 0.25 * kApart}) {
    const double middle = error.worst_share();
    error.look(middle - beside);
    error.look(middle + beside);
  }
  error.look_at_sharpest();
  return error.worst_mm();
}

// MATH section 5, closed form for a constant radius. Never less than the tolerance in a tick: no
// point of a way is farther than half of it from the nearer one of its ends, so even twice as much
// is no chord error whatever the turn. The half is kept free, for a tick around the turn is bound
// by lines between those that begin before it and at it.
double curvature_bound_mm_s(const NurbsCurve& curve, double s_mm, const ScanLimits& limits) {
  const double curvature = vec(curve.derivatives_at(s_mm).second_per_mm).norm();
  const double d = limits.chord_tolerance_mm;
  if (curvature * d >= 1.0) {
    return std::max(2.0 / curvature, d) / limits.period_s;  // it may span the whole circle
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
    const double share = std::sqrt(kAim * limits.chord_tolerance_mm / error);
    v = step / limits.period_s * (i < kUsualAdjustments ? share : std::min(share, kMostLeft));
  }
  return v;
}

// Looked at piece by piece, for pieces are short where a curve turns sharply.
bool is_nearly_straight(const NurbsCurve& curve, double s_mm, double way_mm,
                        const ScanLimits& limits) {
  const double least = kNearlyStraight * limits.feedrate_mm_s;
  const std::size_t first = curve.piece_index(s_mm);
  const std::size_t last = curve.piece_index(s_mm + way_mm);
  if (last - first >= kMostPieces) {
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

std::vector<TickBound> walk(const NurbsCurve& curve, const ScanLimits& limits) {
  std::vector<TickBound> bounds;
  for (double s = 0.0; s < curve.length_mm();) {
    const double v = tick_bound_mm_s(curve, s, limits);
    bounds.push_back({.s_mm = s, .v_mm_s = v});
    const curves::NurbsPiece& piece = curve.pieces()[curve.piece_index(s)];
    const double coarse = 0.25 * (piece.s_end_mm - piece.s_begin_mm);
    double step = 0.5 * v * limits.period_s;
    if (step < kFineShare * coarse &&
        curvature_bound_mm_s(curve, s, limits) > kFarBelow * limits.feedrate_mm_s) {
      step = kFineShare * coarse;
    }
    const bool strides = limits.plan == ScanFor::time_optimum &&
                         is_nearly_straight(curve, s, coarse + v * limits.period_s, limits);
    step = std::max(strides ? coarse : std::min(step, coarse), kLeastStep_mm);
    // Those behind may be much shorter.
    const bool passes_over_one = curve.piece_index(s + step) > curve.piece_index(s) + 1;
    s = passes_over_one ? std::max(piece.s_end_mm, s + kLeastStep_mm) : s + step;
  }
  return bounds;
}

bool is_convex(const TickBound& before, const TickBound& at, const TickBound& after) {
  const double share = (at.s_mm - before.s_mm) / (after.s_mm - before.s_mm);
  const double line = before.v_mm_s + share * (after.v_mm_s - before.v_mm_s);
  return line - at.v_mm_s > kConvex * at.v_mm_s;
}

// True: there are more of them now.
bool refine(std::vector<TickBound>& bounds, const NurbsCurve& curve, const ScanLimits& limits) {
  std::vector<TickBound> finer;
  bool convex = false;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const bool convex_before = convex;
    convex = i > 0 && i + 1 < bounds.size() && is_convex(bounds[i - 1], bounds[i], bounds[i + 1]);
    if (i > 0 && (convex || convex_before) &&
        bounds[i].s_mm - bounds[i - 1].s_mm > 2.0 * kLeastStep_mm) {
      const double middle = 0.5 * (bounds[i - 1].s_mm + bounds[i].s_mm);
      finer.push_back({.s_mm = middle, .v_mm_s = tick_bound_mm_s(curve, middle, limits)});
    }
    finer.push_back(bounds[i]);
  }
  const bool more = finer.size() > bounds.size();
  bounds = std::move(finer);
  return more;
}

}  // namespace

std::vector<TickBound> tick_bounds(const NurbsCurve& curve, const ScanLimits& limits) {
  std::vector<TickBound> bounds = walk(curve, limits);
  for (int i = 0; i < kRefinements && refine(bounds, curve, limits); ++i) {
  }
  return bounds;
}

}  // namespace kerf::lookahead
