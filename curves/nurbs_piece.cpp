#include "curves/nurbs_piece.hpp"

#include <cassert>
#include <cmath>

namespace kerf::curves {
namespace {

using Homogeneous = Eigen::Array4d;

// y in [-1, 1]; not a number counts as the begin.
double scaled_length(const NurbsPiece& piece, double s_mm) noexcept {
  if (s_mm >= piece.s_end_mm) {
    return 1.0;
  }
  if (!(s_mm > piece.s_begin_mm)) {
    return -1.0;
  }
  return 2.0 * ((s_mm - piece.s_begin_mm) / (piece.s_end_mm - piece.s_begin_mm)) - 1.0;
}

Homogeneous coefficient(const NurbsPiece& piece, int k) noexcept {
  return Eigen::Map<const Homogeneous>(piece.coefficients[static_cast<std::size_t>(k)].data());
}

Position placed(const NurbsPiece& piece, const Homogeneous& value) noexcept {
  const double scale = 1.0 / value[3];
  return {piece.origin_mm[0] + scale * value[0], piece.origin_mm[1] + scale * value[1],
          piece.origin_mm[2] + scale * value[2]};
}

// The polynomials' values and derivatives; f2 is divided by 2 and f3 by 6 so far.
struct Taylor {
  Homogeneous f, f1, f2, f3;
};

template <int kDegree>
Taylor expand(const NurbsPiece& piece, double x) noexcept {
  const int degree = kDegree > 0 ? kDegree : piece.degree;
  Taylor t{coefficient(piece, degree), Homogeneous::Zero(), Homogeneous::Zero(),
           Homogeneous::Zero()};
  for (int i = 1; i <= degree; ++i) {  // the first steps without the products by zero
    if (i > 3) {
      t.f3 = t.f3 * x;
    }
    if (i > 2) {
      t.f3 += t.f2;
    }
    if (i > 2) {
      t.f2 = t.f2 * x;
    }
    if (i > 1) {
      t.f2 += t.f1;
    }
    if (i > 1) {
      t.f1 = t.f1 * x;
    }
    t.f1 += t.f;
    t.f = t.f * x + coefficient(piece, degree - i);
  }
  return t;
}

// The usual degrees with their loop unrolled.
Taylor expand(const NurbsPiece& piece, double x) noexcept {
  switch (piece.degree) {
    case 2:
      return expand<2>(piece, x);
    case 3:
      return expand<3>(piece, x);
    default:
      return expand<0>(piece, x);
  }
}

// The point seen from the origin of the piece, and its derivatives by x. All four lanes go through
// the quotient rule together; the fourth of the derivatives is 0.
struct ByParameter {
  Homogeneous point, first, second, third;
};

ByParameter derivatives_by_x(const NurbsPiece& piece, double x) noexcept {
  const Taylor t = expand(piece, x);
  const double scale = 1.0 / t.f[3];
  const double w1 = scale * t.f1[3];
  const double w2 = scale * 2.0 * t.f2[3];
  const double w3 = scale * 6.0 * t.f3[3];
  ByParameter d;
  d.point = scale * t.f;
  d.first = scale * t.f1 - w1 * d.point;
  d.first[3] = 0.0;
  d.second = (2.0 * scale) * t.f2 - (2.0 * w1) * d.first - w2 * d.point;
  d.second[3] = 0.0;
  d.third = (6.0 * scale) * t.f3 - (3.0 * w1) * d.second - (3.0 * w2) * d.first - w3 * d.point;
  d.third[3] = 0.0;
  return d;
}

double dot(const Homogeneous& a, const Homogeneous& b) noexcept {
  return (a * b).sum();
}

Position first_three(const Homogeneous& v) noexcept {
  return {v[0], v[1], v[2]};
}

}  // namespace

// Even and odd powers in two chains that the processor runs side by side.
double local_parameter(const NurbsPiece& piece, double s_mm) noexcept {
  static_assert(NurbsPiece::kMapDegree == 9);
  const auto& c = piece.local_by_length;
  const double y = scaled_length(piece, s_mm);
  const double z = y * y;
  const double even = (((c[8] * z + c[6]) * z + c[4]) * z + c[2]) * z + c[0];
  const double odd = (((c[9] * z + c[7]) * z + c[5]) * z + c[3]) * z + c[1];
  const double x = even + y * odd;
  return x > 1.0 ? 1.0 : (x < -1.0 ? -1.0 : x);
}

double length_at(const NurbsPiece& piece, double x) noexcept {
  assert(-1.0 <= x && x <= 1.0);
  constexpr int kSteps = 4;
  const auto& c = piece.local_by_length;
  double y = x;
  for (int i = 0; i < kSteps; ++i) {
    double value = 0.0;
    double slope = 0.0;
    for (std::size_t k = c.size(); k-- > 0;) {
      slope = slope * y + value;
      value = value * y + c[k];
    }
    if (!(slope > 0.0)) {
      break;
    }
    y -= (value - x) / slope;
  }
  y = y > 1.0 ? 1.0 : (y > -1.0 ? y : -1.0);
  return piece.s_begin_mm + 0.5 * (1.0 + y) * (piece.s_end_mm - piece.s_begin_mm);
}

Position NurbsPiece::at(double s_mm) const noexcept {
  if (ends_curve && s_mm >= s_end_mm) {
    return end_mm;
  }
  const double x = local_parameter(*this, s_mm);
  Homogeneous f = coefficient(*this, degree);
  for (int k = degree - 1; k >= 0; --k) {
    f = f * x + coefficient(*this, k);
  }
  return placed(*this, f);
}

PathDerivatives NurbsPiece::derivatives_at(double s_mm) const noexcept {
  const double x = local_parameter(*this, s_mm);
  ByParameter d = derivatives_by_x(*this, x);
  PathDerivatives result;
  result.position_mm = ends_curve && s_mm >= s_end_mm
                           ? end_mm
                           : Position{origin_mm[0] + d.point[0], origin_mm[1] + d.point[1],
                                      origin_mm[2] + d.point[2]};

  // Only pieces around a point where the parametrisation stands still fall below the floor.
  const double floor_mm = 1e-4 * 0.5 * (s_end_mm - s_begin_mm);
  double speed_squared = dot(d.first, d.first);
  for (const double elsewhere : {0.5, -0.5}) {
    if (speed_squared > floor_mm * floor_mm) {
      break;
    }
    d = derivatives_by_x(*this, elsewhere);
    speed_squared = dot(d.first, d.first);
  }

  // With C1, C2, C3 for the derivatives by x and v = |C1|: tangent t = C1 / v, curvature
  // k = (C2 - (t C2) t) / v^2 and dk/ds = (C3 - (t C3) t) / v^3 - 3 (t C2) / v^2 k - |k|^2 t.
  const double per_speed = 1.0 / std::sqrt(speed_squared);
  const double per_squared = per_speed * per_speed;
  const Homogeneous tangent = per_speed * d.first;
  const double change = dot(tangent, d.second) * per_squared;
  const Homogeneous curvature = per_squared * d.second - change * tangent;
  const double along = dot(tangent, d.third) * per_squared * per_speed + dot(curvature, curvature);
  const Homogeneous third =
      (per_squared * per_speed) * d.third - (3.0 * change) * curvature - along * tangent;
  result.first = first_three(tangent);
  result.second_per_mm = first_three(curvature);
  result.third_per_mm2 = first_three(third);
  return result;
}

double NurbsPiece::u_at(double s_mm) const noexcept {
  const double x = local_parameter(*this, s_mm);
  return 0.5 * ((1.0 - x) * u_begin + (1.0 + x) * u_end);
}

double speed_mm(const NurbsPiece& piece, double x) noexcept {
  Homogeneous f = coefficient(piece, piece.degree);
  Homogeneous f1 = Homogeneous::Zero();
  for (int k = piece.degree - 1; k >= 0; --k) {
    f1 = f1 * x + f;
    f = f * x + coefficient(piece, k);
  }
  const double scale = 1.0 / f[3];
  Homogeneous first = scale * f1 - (scale * f1[3] * scale) * f;
  first[3] = 0.0;
  return std::sqrt(dot(first, first));
}

}  // namespace kerf::curves
