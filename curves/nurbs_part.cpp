// A stretch of a NURBS curve. The pieces within it stay as they are; of the two that its ends lie
// in, the polynomials are moved to the remaining interval of x and their lengths fitted anew, in
// halves where rounding leaves the fit of all of it too far off.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "curves/nurbs_curve.hpp"
#include "curves/piece_fit.hpp"

namespace kerf::curves {
namespace {

constexpr int kHalvings = 8;

struct Interval {
  double begin = -1.0;
  double end = 1.0;
};

// The polynomials about the middle of the interval, scaled so that it becomes [-1, 1].
void restrict(NurbsPiece& piece, const Interval& to) {
  const double middle = 0.5 * (to.begin + to.end);
  const double half = 0.5 * (to.end - to.begin);
  auto& c = piece.coefficients;
  const auto degree = static_cast<std::size_t>(piece.degree);
  for (std::size_t round = 0; round < degree; ++round) {
    for (std::size_t k = degree; k-- > round;) {
      for (std::size_t i = 0; i < 4; ++i) {
        c[k][i] += middle * c[k + 1][i];
      }
    }
  }
  const double weight = c[0][3];
  double scale = 1.0 / weight;
  for (std::size_t k = 0; k <= degree; ++k) {
    for (double& value : c[k]) {
      value *= scale;
    }
    scale *= half;
  }
  const Position moved{c[0][0], c[0][1], c[0][2]};
  for (std::size_t i = 0; i < 3; ++i) {
    piece.origin_mm[i] += moved[i];
    for (std::size_t k = 0; k <= degree; ++k) {
      c[k][i] -= moved[i] * c[k][3];
    }
  }
  const double u_middle = 0.5 * (piece.u_begin + piece.u_end);
  const double u_half = 0.5 * (piece.u_end - piece.u_begin);
  piece.u_begin = u_middle + u_half * to.begin;
  piece.u_end = u_middle + u_half * to.end;
}

// The pieces of a part, counted from its begin.
class Part {
 public:
  // As it is.
  void append(NurbsPiece piece, double length_mm) {
    piece.s_begin_mm = s_mm_;
    s_mm_ += length_mm;
    piece.s_end_mm = s_mm_;
    piece.ends_curve = false;
    if (piece.s_end_mm > piece.s_begin_mm) {
      pieces.push_back(piece);
    }
  }
  // With its length to be fitted.
  // NOLINTNEXTLINE(misc-no-recursion): no deeper than kHalvings.
  void append_restricted(const NurbsPiece& whole, const Interval& to, int halvings = 0) {
    NurbsPiece piece = whole;
    restrict(piece, to);
    const double length_mm = fit_length_map(piece);
    if (length_mm > 0.0) {
      append(piece, length_mm);
    } else if (halvings < kHalvings) {
      append_restricted(piece, {-1.0, 0.0}, halvings + 1);
      append_restricted(piece, {0.0, 1.0}, halvings + 1);
    } else {
      piece.local_by_length = {0.0, 1.0};
      append(piece, 2.0 * speed_mm(piece, 0.0));
    }
  }

  std::vector<NurbsPiece> pieces;

 private:
  double s_mm_ = 0.0;
};

}  // namespace

std::optional<NurbsCurve> NurbsCurve::part(const Stretch& stretch) const {
  assert(0.0 <= stretch.begin_mm && stretch.begin_mm < stretch.end_mm);
  assert(stretch.end_mm <= length_mm());
  Part part;
  for (std::size_t i = piece_index(stretch.begin_mm); i < pieces_.size(); ++i) {
    const NurbsPiece& whole = pieces_[i];
    if (whole.s_begin_mm >= stretch.end_mm) {
      break;
    }
    const bool cut_begin = whole.s_begin_mm < stretch.begin_mm;
    const bool cut_end = whole.s_end_mm > stretch.end_mm;
    if (!cut_begin && !cut_end) {
      part.append(whole, whole.s_end_mm - whole.s_begin_mm);
      continue;
    }
    const Interval to{cut_begin ? local_parameter(whole, stretch.begin_mm) : -1.0,
                      cut_end ? local_parameter(whole, stretch.end_mm) : 1.0};
    if (to.begin < to.end) {
      part.append_restricted(whole, to);
    }
  }
  if (part.pieces.empty()) {
    return std::nullopt;
  }
  part.pieces.back().ends_curve = true;
  part.pieces.back().end_mm = at(stretch.end_mm);
  return NurbsCurve(std::move(part.pieces));
}

}  // namespace kerf::curves
