#include "lookahead/optimum/grid/block_path.hpp"

#include <algorithm>
#include <cmath>

#include "curves/curve.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::lookahead {

using curves::vec;

namespace {

// Of a derivative's size: what is less is rounding.
constexpr double kJump = 1e-6;
// Of what an axis' acceleration may change within a tick, at the highest feedrate: where the
// parameter's speed nearly vanishes, rounding makes more of a derivative jump than kJump.
constexpr double kSlightJump = 1e-6;
// Of the fourth derivative's size, found from differences over so much of a piece.
constexpr double kKink = 0.05;
constexpr double kStepOfPiece = 1e-3;
constexpr double kArcStep_rad = 0.05;
constexpr int kPlacesOfPiece = 4;
// A sharper apex is a corner to any drive, and a rest there costs some milliseconds: what there is
// to gain on it is not worth its numbers.
constexpr double kStopRadius_mm = 1e-7;

bool differ(const curves::Position& a, const curves::Position& b) {
  const double size = std::max(vec(a).norm(), vec(b).norm());
  return (vec(a) - vec(b)).norm() > kJump * size;
}

// The slope of the third derivative at an end of a piece, from its own side.
Eigen::Vector3d fourth_derivative(const curves::NurbsPiece& piece, double end_mm) {
  const double length = piece.s_end_mm - piece.s_begin_mm;
  const double step = (end_mm == piece.s_end_mm ? -kStepOfPiece : kStepOfPiece) * length;
  return (vec(piece.derivatives_at(end_mm + step).third_per_mm2) -
          vec(piece.derivatives_at(end_mm).third_per_mm2)) /
         step;
}

// Only the fourth derivative jumps where they join, as at a simple knot of degree 4: the jerk of an
// axis turns off there without a jump.
bool has_kink(const curves::NurbsPiece& before, const curves::NurbsPiece& after) {
  if (before.degree <= 3) {
    return false;
  }
  const Eigen::Vector3d left = fourth_derivative(before, before.s_end_mm);
  const Eigen::Vector3d right = fourth_derivative(after, after.s_begin_mm);
  return (right - left).norm() > kKink * std::max(left.norm(), right.norm());
}

// The tangent goes on: what differs is rounding.
BlockEnd end_of(const curves::PathDerivatives& path) {
  return {{.second_per_mm = path.second_per_mm}, vec(path.third_per_mm2).cwiseAbs().maxCoeff()};
}

// The pieces of a curve are short where it turns sharply (curves/arc_length.cpp), even where a
// feature is too small for the scan of the chord error.
void add_places_of_pieces(const curves::NurbsCurve& curve, std::vector<double>& places) {
  for (const curves::NurbsPiece& piece : curve.pieces()) {
    const double step = (piece.s_end_mm - piece.s_begin_mm) / kPlacesOfPiece;
    for (int k = 0; k < kPlacesOfPiece; ++k) {
      places.push_back(piece.s_begin_mm + step * k);
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

// Where the curve turns more sharply than kStopRadius_mm: of each such stretch the sharpest place.
std::vector<double> sharp_places(const curves::NurbsCurve& curve) {
  std::vector<double> places{0.0};
  add_places_of_pieces(curve, places);
  std::vector<double> sharp;
  double sharpest = 0.0;
  for (const double s : places) {
    const double curvature = vec(curve.derivatives_at(s).second_per_mm).norm();
    if (!(curvature * kStopRadius_mm > 1.0) || s == 0.0) {
      sharpest = 0.0;
    } else if (curvature > sharpest) {
      if (sharpest > 0.0) {
        sharp.pop_back();
      }
      sharp.push_back(s);
      sharpest = curvature;
    }
  }
  return sharp;
}

}  // namespace

Bound BlockPath::feedrate_at(double s_mm) const {
  const VelocityLimitCurve& limit_curve = block_->limit_curve;
  const Bound block{block_->along.feedrate_mm_s, block_->along.from.feedrate};
  const auto lower = [&block](double v_mm_s, Constraint from) {
    return v_mm_s < block.value ? Bound{v_mm_s, from} : block;
  };
  if (limit_curve.empty()) {
    return block;
  }
  const auto after = std::ranges::lower_bound(limit_curve, s_mm, {}, &FeedSample::s_mm);
  if (after == limit_curve.begin()) {
    return lower(after->v_mm_s, after->limit);
  }
  if (after == limit_curve.end()) {
    return lower(limit_curve.back().v_mm_s, limit_curve.back().limit);
  }
  const auto before = std::prev(after);
  const double share = (s_mm - before->s_mm) / (after->s_mm - before->s_mm);
  return lower(before->v_mm_s + share * (after->v_mm_s - before->v_mm_s),
               before->v_mm_s < after->v_mm_s ? before->limit : after->limit);
}

PathSample BlockPath::at(double s_mm) const {
  const Bound feedrate = feedrate_at(s_mm);
  PathSample end{curves::derivatives_at(block_->curve, s_mm), s_mm};
  end.feedrate_mm_s = feedrate.value;
  end.limit = feedrate.from;
  for (std::size_t k = 0; k < 3; ++k) {
    if (end.first[k] != 0.0) {
      end.bind_feedrate(limits_->axes[k].velocity_mm_s / std::abs(end.first[k]),
                        interp::of_axis(Constraint::x_velocity, k));
    }
  }
  return end;
}

std::vector<double> BlockPath::scan_places() const {
  std::vector<double> places{0.0};
  if (!block_->limit_curve.empty()) {
    for (const FeedSample& sample : block_->limit_curve) {
      if (sample.s_mm > places.back()) {
        places.push_back(sample.s_mm);
      }
    }
  } else if (const auto* arc = std::get_if<curves::Arc>(&block_->curve)) {
    const double angle = arc->length_mm() * arc->in_plane_share() / arc->radius_mm();
    const auto parts = static_cast<int>(std::ceil(angle / kArcStep_rad));
    for (int k = 1; k <= parts; ++k) {
      places.push_back(length_mm() * k / parts);
    }
  }
  if (const auto* nurbs = std::get_if<curves::NurbsCurve>(&block_->curve)) {
    add_places_of_pieces(*nurbs, places);
  }
  if (places.back() < length_mm()) {
    places.push_back(length_mm());
  }
  return places;
}

double BlockPath::piece_mm(double s_mm) const {
  const auto* nurbs = std::get_if<curves::NurbsCurve>(&block_->curve);
  if (nurbs == nullptr) {
    return kUnbounded;
  }
  const curves::NurbsPiece& piece = nurbs->pieces()[nurbs->piece_index(s_mm)];
  return piece.s_end_mm - piece.s_begin_mm;
}

bool BlockPath::joins_pieces(double s_mm) const {
  const auto* nurbs = std::get_if<curves::NurbsCurve>(&block_->curve);
  return nurbs != nullptr && nurbs->pieces()[nurbs->piece_index(s_mm)].s_begin_mm == s_mm;
}

bool BlockPath::counts(const Jump& jump, double s_mm) const {
  const double v = at(s_mm).feedrate_mm_s;
  for (std::size_t k = 0; k < limits_->axes.size(); ++k) {
    const double step =
        std::abs(jump.after.second_per_mm[k] - jump.before.second_per_mm[k]) * v * v;
    const double jerk = std::min(limits_->axes[k].jerk_mm_s3, limits_->path.jerk_mm_s3);
    if (step > kSlightJump * jerk * limits_->period_s) {
      return true;
    }
  }
  return false;
}

std::vector<BlockPath::Break> BlockPath::breaks() const {
  std::vector<Break> places;
  if (const auto* nurbs = std::get_if<curves::NurbsCurve>(&block_->curve)) {
    const std::vector<curves::NurbsPiece>& pieces = nurbs->pieces();
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      const double s = pieces[i].s_end_mm;
      const curves::PathDerivatives before = pieces[i].derivatives_at(s);
      const curves::PathDerivatives after = pieces[i + 1].derivatives_at(s);
      const Jump jump{.before = end_of(before), .after = end_of(after)};
      if (differ(before.second_per_mm, after.second_per_mm) && counts(jump, s)) {
        places.push_back({s, jump});
      } else if (differ(before.third_per_mm2, after.third_per_mm2) ||
                 has_kink(pieces[i], pieces[i + 1])) {
        places.push_back({s});
      }
    }
    for (const double s : sharp_places(*nurbs)) {
      places.push_back({.s_mm = s, .rest = true});
    }
  }
  const VelocityLimitCurve& limit_curve = block_->limit_curve;
  for (std::size_t i = 1; i + 1 < limit_curve.size(); ++i) {
    if (limit_curve[i].v_mm_s < limit_curve[i - 1].v_mm_s &&
        limit_curve[i].v_mm_s <= limit_curve[i + 1].v_mm_s) {
      places.push_back({.s_mm = limit_curve[i].s_mm, .valley = true});
    }
  }
  std::ranges::sort(places, {}, &Break::s_mm);
  return places;
}

}  // namespace kerf::lookahead
