#include <algorithm>
#include <cmath>
#include <vector>

#include "lookahead/path/feed_scan.hpp"

namespace kerf::lookahead {

using curves::vec;

namespace {

constexpr int kChordPoints = 7;  // inside a tick
// A piece is one of the sharpest if a neighbour is this many times as long and none is shorter, but
// for rounding: pieces are halved towards a needle, and even knots have none.
constexpr double kClearlyLonger = 1.5;
constexpr double kRounding = 1.0 + 1e-6;
constexpr double kHardlyCurved = 1e-4;  // cosines would cancel

Eigen::Vector3d beyond(const curves::PathDerivatives& end, double way_mm) {
  const double curvature = vec(end.second_per_mm).norm();
  const double turn = curvature * way_mm;
  if (std::abs(turn) < kHardlyCurved) {
    return vec(end.position_mm) + way_mm * vec(end.first) +
           0.5 * way_mm * way_mm * vec(end.second_per_mm);
  }
  return vec(end.position_mm) + std::sin(turn) / curvature * vec(end.first) +
         (1.0 - std::cos(turn)) / (curvature * curvature) * vec(end.second_per_mm);
}

// The largest distance from a chord of the points looked at.
class ChordError {
 public:
  ChordError(const ContinuedCurve& path, const curves::Stretch& tick)
      : path_(path),
        tick_(tick),
        from_(path.at(tick.begin_mm)),
        chord_(path.at(tick.end_mm) - from_),
        chord_mm2_(chord_.squaredNorm()) {}

  void look(double share) {
    const Eigen::Vector3d offset =
        path_.at(tick_.begin_mm + (tick_.end_mm - tick_.begin_mm) * share) - from_;
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
    const curves::NurbsCurve& curve = path_.curve();
    const std::vector<curves::NurbsPiece>& pieces = curve.pieces();
    const auto length = [&](std::size_t k) { return pieces[k].s_end_mm - pieces[k].s_begin_mm; };
    const std::size_t last = std::min(curve.piece_index(tick_.end_mm) + 1, pieces.size() - 1);
    for (std::size_t k = std::max<std::size_t>(curve.piece_index(tick_.begin_mm), 1); k < last;
         ++k) {
      const auto [shorter, longer] = std::minmax({length(k - 1), length(k + 1)});
      if (length(k) <= kRounding * shorter && kClearlyLonger * length(k) <= longer) {
        for (const double s_mm : {pieces[k].s_begin_mm, pieces[k].s_end_mm}) {
          if (s_mm > tick_.begin_mm && s_mm < tick_.end_mm) {
            look((s_mm - tick_.begin_mm) / (tick_.end_mm - tick_.begin_mm));
          }
        }
      }
    }
  }

  [[nodiscard]] double worst_share() const { return worst_share_; }
  [[nodiscard]] double worst_mm() const { return std::sqrt(worst_mm2_); }

 private:
  const ContinuedCurve& path_;
  curves::Stretch tick_;
  Eigen::Vector3d from_;
  Eigen::Vector3d chord_;
  double chord_mm2_;
  double worst_mm2_ = 0.0;
  double worst_share_ = 0.5;
};

}  // namespace

ContinuedCurve::ContinuedCurve(const curves::NurbsCurve& curve)
    : curve_(curve),
      begin_(curve.derivatives_at(0.0)),
      end_(curve.derivatives_at(curve.length_mm())) {}

Eigen::Vector3d ContinuedCurve::at(double s_mm) const {
  if (s_mm < 0.0) {
    return beyond(begin_, s_mm);
  }
  const double past_mm = s_mm - curve_.length_mm();
  return past_mm > 0.0 ? beyond(end_, past_mm) : Eigen::Vector3d(vec(curve_.at(s_mm)));
}

double chord_error_mm(const ContinuedCurve& path, const curves::Stretch& tick) {
  ChordError error(path, tick);
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

}  // namespace kerf::lookahead
