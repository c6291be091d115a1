#include "curves/nurbs_piece.hpp"

#include <cmath>

namespace kerf::curves {
namespace {

using Homogeneous = Eigen::Array4d;

// y in [-1, 1]; not a number counts as the begin.
double scaled_length(const NurbsPiece& piece, double s_mm) noexcept {
  if (s_mm >= piece.s_end_mm)
    return 1.0;
  if (!(s_mm > piece.s_begin_mm))
    return -1.0;
  return 2.0 * ((s_mm - piece.s_begin_mm) / (piece.s_end_mm - piece.s_begin_mm)) - 1.0;
}

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

Homogeneous coefficient(const NurbsPiece& piece, int k) noexcept {
  return Eigen::Map<const Homogeneous>(piece.coefficients[static_cast<std::size_t>(k)].data());
}

Position placed(const NurbsPiece& piece, const Homogeneous& value) noexcept {
  const double scale = 1.0 / value[3];
  return {piece.origin_mm[0] + scale * value[0], piece.origin_mm[1] + scale * value[1],
          piece.origin_mm[2] + scale * value[2]};
}

// Derivatives by x, the point seen from the origin of the piece.
struct ByParameter {
  Homogeneous value = Homogeneous::Zero();
  Eigen::Vector3d first, second, third;
};

ByParameter derivatives_by_x(const NurbsPiece& piece, double x) noexcept {
  Homogeneous f = coefficient(piece, piece.degree);
  Homogeneous f1 = Homogeneous::Zero();
  Homogeneous f2 = Homogeneous::Zero();  // by 2
  Homogeneous f3 = Homogeneous::Zero();  // by 6
  for (int k = piece.degree - 1; k >= 0; --k) {
    f3 = f3 * x + f2;
    f2 = f2 * x + f1;
    f1 = f1 * x + f;
    f = f * x + coefficient(piece, k);
  }
  f2 *= 2.0;
  f3 *= 6.0;
  const double scale = 1.0 / f[3];
  ByParameter d;
  d.value = f;
  const Eigen::Vector3d point = scale * f.head<3>().matrix();
  d.first = scale * (f1.head<3>().matrix() - f1[3] * point);
  d.second = scale * (f2.head<3>().matrix() - 2.0 * f1[3] * d.first - f2[3] * point);
  d.third = scale * (f3.head<3>().matrix() - 3.0 * f1[3] * d.second - 3.0 * f2[3] * d.first -
                     f3[3] * point);
  return d;
}

}  // namespace

Position NurbsPiece::at(double s_mm) const noexcept {
  if (ends_curve && s_mm >= s_end_mm)
    return end_mm;
  const double x = local_parameter(*this, s_mm);
  Homogeneous f = coefficient(*this, degree);
  for (int k = degree - 1; k >= 0; --k)
    f = f * x + coefficient(*this, k);
  return placed(*this, f);
}

PathDerivatives NurbsPiece::derivatives_at(double s_mm) const noexcept {
  const double x = local_parameter(*this, s_mm);
  ByParameter d = derivatives_by_x(*this, x);
  PathDerivatives result;
  result.position_mm = ends_curve && s_mm >= s_end_mm ? end_mm : placed(*this, d.value);

  // Only pieces around a point where the parametrisation stands still fall below the floor.
  const double floor_mm = 1e-4 * 0.5 * (s_end_mm - s_begin_mm);
  double speed_squared = d.first.squaredNorm();
  for (const double elsewhere : {0.5, -0.5}) {
    if (speed_squared > floor_mm * floor_mm)
      break;
    d = derivatives_by_x(*this, elsewhere);
    speed_squared = d.first.squaredNorm();
  }

  const double per_speed = 1.0 / std::sqrt(speed_squared);
  const Eigen::Vector3d tangent = per_speed * d.first;
  const double change = tangent.dot(d.second) * per_speed;  // d|C'|/dx by |C'|
  const double per_squared = per_speed * per_speed;
  const Eigen::Vector3d curvature = per_squared * d.second - change * per_speed * tangent;
  const Eigen::Vector3d across = d.third - tangent.dot(d.third) * tangent;
  const Eigen::Vector3d third = per_squared * per_speed * across -
                                3.0 * change * per_speed * curvature -
                                curvature.squaredNorm() * tangent;
  result.first = to_position(tangent);
  result.second_per_mm = to_position(curvature);
  result.third_per_mm2 = to_position(third);
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
  const Eigen::Vector3d point = scale * f.head<3>().matrix();
  return (scale * (f1.head<3>().matrix() - f1[3] * point)).norm();
}

}  // namespace kerf::curves
