// Idea. The speed |r'(w)| = 3 d |(1 - w)^2 tA + w^2 tB| depends on the turn between the two lines
// alone, and is the same from both ends. It vanishes at w = 1/2 +- i t/2 with t = tan((pi - turn)
// / 4), nearer to the real axis the sharper the turn, and at farther places above these. So it is
// known beforehand how long a piece may be: about as long as it is far from there, and at the ends,
// where as large a share of its length is more to be off by, a little shorter. With w = (1 + t x) /
// 2 and x = q + kCube q^3 pieces of one width in q are that. The second half is the first one
// mirrored and needs no fit of its own.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "curves/curve_builders.hpp"
#include "curves/piece_fit.hpp"

namespace kerf::curves {
namespace {

// The first makes half curves of random turns into the fewest pieces. A width in q that can nearly
// always be fitted, and how it changes with the size of the curve, which is fitted to a distance.
constexpr double kCube = 0.08;
constexpr double kWidthOf1mm = 0.32;
constexpr double kPowerOfWidth = -0.07;
constexpr int kMaxPieces = 64;  // of a half

struct Interval {
  double middle = 0.0;  // in w
  double half = 0.0;
};

struct MappedInterval {
  Interval w;
  LengthMap map;
};

double x_of(double q) {
  return q + kCube * q * q * q;
}

double q_of(double x) {
  const double scale = std::sqrt(3.0 * kCube);
  return 2.0 / scale * std::sinh(std::asinh(1.5 * scale * x) / 3.0);
}

class CornerCubic {
 public:
  explicit CornerCubic(const CornerLines& lines)
      : way_mm_(lines.way_mm),
        corner_(vec(lines.corner_mm)),
        in_(vec(lines.direction_in)),
        out_(vec(lines.direction_out)),
        cosine_(in_.dot(out_)) {}

  // The intervals of the first half; none: one of them cannot be fitted with so many.
  [[nodiscard]] std::vector<MappedInterval> first_half(int count) const {
    const double t = to_singular();
    const double q_end = q_of(1.0 / t);
    std::vector<MappedInterval> mapped;
    mapped.reserve(static_cast<std::size_t>(count));
    double begin = 0.0;
    for (int i = 1; i <= count; ++i) {
      const double q = q_end * (1.0 - static_cast<double>(i) / count);
      const double end = i == count ? 0.5 : 0.5 - 0.5 * t * x_of(q);
      const Interval w{0.5 * (begin + end), 0.5 * (end - begin)};
      const auto map = fit(w);
      if (!map) {
        return {};
      }
      mapped.push_back({w, *map});
      begin = end;
    }
    return mapped;
  }

  [[nodiscard]] int likely_count() const {
    const double width = kWidthOf1mm * std::pow(way_mm_, kPowerOfWidth);
    const double count = std::ceil(q_of(1.0 / to_singular()) / width);
    return static_cast<int>(std::clamp(count, 1.0, 1.0 * kMaxPieces));
  }

  // The geometry: r(m + h x) by powers of x. Its place along the curve is left to the caller.
  [[nodiscard]] NurbsPiece piece(const Interval& w) const {
    const double m = w.middle;
    const double h = w.half;
    const double p = 1.0 - m;
    NurbsPiece made;
    made.degree = 3;
    made.u_begin = m - h;
    made.u_end = m + h;
    made.origin_mm = to_position(corner_ + way_mm_ * (m * m * m * out_ - p * p * p * in_));
    const std::array<Eigen::Vector3d, 3> powers{
        (3.0 * way_mm_ * h) * (p * p * in_ + m * m * out_),
        (3.0 * way_mm_ * h * h) * (m * out_ - p * in_),
        (way_mm_ * h * h * h) * (in_ + out_),
    };
    made.coefficients[0] = {0.0, 0.0, 0.0, 1.0};
    for (std::size_t k = 0; k < powers.size(); ++k) {
      made.coefficients[k + 1] = {powers[k].x(), powers[k].y(), powers[k].z(), 0.0};
    }
    return made;
  }

  [[nodiscard]] Position end_mm() const { return to_position(corner_ + way_mm_ * out_); }

 private:
  // t above.
  [[nodiscard]] double to_singular() const {
    const double half_sine = 0.5 * (out_ - in_).norm();
    return 0.5 * (out_ + in_).norm() / (1.0 + half_sine);
  }

  [[nodiscard]] std::optional<LengthMap> fit(const Interval& w) const {
    const ArcLengthRule& rule = ArcLengthRule::get();
    const auto speed_at = [&](const auto& x) {
      const auto b = (w.middle + w.half * x.array()).eval();
      const auto bb = b.square().eval();
      const auto aa = (1.0 - b).square().eval();
      const auto squared = aa.square() + (2.0 * cosine_) * aa * bb + bb.square();
      return (3.0 * way_mm_ * w.half * squared.sqrt()).matrix().eval();
    };
    const NodeSpeeds speed = speed_at(rule.nodes);
    auto map = length_map(speed);
    if (map && !holds(*map, speed, speed_at(rule.checks))) {
      map.reset();
    }
    return map;
  }

  double way_mm_;
  Eigen::Vector3d corner_;
  Eigen::Vector3d in_;
  Eigen::Vector3d out_;
  double cosine_;
};

// x(s) of the piece at the same place of the other half: x(-y) with its sign changed.
LengthMap mirrored(LengthMap map) {
  for (std::size_t k = 0; k < map.local_by_length.size(); k += 2) {
    map.local_by_length[k] = -map.local_by_length[k];
  }
  return map;
}

}  // namespace

std::optional<NurbsCurve> corner_cubic(const CornerLines& lines) {
  assert(lines.way_mm > 0.0);
  const CornerCubic cubic(lines);
  std::vector<MappedInterval> half;
  for (int count = cubic.likely_count(); half.empty() && count <= kMaxPieces; ++count) {
    half = cubic.first_half(count);
  }
  std::vector<NurbsPiece> pieces;
  pieces.reserve(2 * half.size());
  double s_mm = 0.0;
  const auto append = [&](const Interval& w, const LengthMap& map) {
    NurbsPiece& piece = pieces.emplace_back(cubic.piece(w));
    piece.local_by_length = map.local_by_length;
    piece.s_begin_mm = s_mm;
    s_mm += map.length_mm;
    piece.s_end_mm = s_mm;
  };
  for (const MappedInterval& at : half) {
    append(at.w, at.map);
  }
  std::reverse(half.begin(), half.end());
  for (const MappedInterval& at : half) {
    append({1.0 - at.w.middle, at.w.half}, mirrored(at.map));
  }
  if (pieces.empty()) {
    return std::nullopt;
  }
  pieces.back().ends_curve = true;
  pieces.back().end_mm = cubic.end_mm();
  return NurbsCurve::from_pieces(std::move(pieces));
}

}  // namespace kerf::curves
