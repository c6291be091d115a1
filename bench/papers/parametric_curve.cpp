#include "bench/papers/parametric_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kerf::bench {

ParametricCurve::ParametricCurve(const curves::NurbsData& data) {
  Net net{.degree = data.degree, .points = {}, .knots = data.knots};
  for (const curves::ControlPoint& point : data.points) {
    Eigen::Vector4d homogeneous;
    homogeneous << point.weight * curves::vec(point.position_mm), point.weight;
    net.points.push_back(homogeneous);
  }
  nets_.push_back(std::move(net));
  nets_.push_back(derivative_of(nets_[0]));
  nets_.push_back(derivative_of(nets_[1]));
}

// [NurbsBook, equation 3.8]
ParametricCurve::Net ParametricCurve::derivative_of(const Net& net) {
  const auto p = static_cast<std::size_t>(net.degree);
  Net derived{.degree = net.degree - 1,
              .points = {},
              .knots = {net.knots.begin() + 1, net.knots.end() - 1}};
  for (std::size_t i = 0; i + 1 < net.points.size(); ++i) {
    const double width = net.knots[i + p + 1] - net.knots[i + 1];
    derived.points.emplace_back(
        width > 0.0 ? Eigen::Vector4d(net.degree / width * (net.points[i + 1] - net.points[i]))
                    : Eigen::Vector4d::Zero());
  }
  return derived;
}

// De Boor's triangle [NurbsBook, section 2.5].
Eigen::Vector4d ParametricCurve::value(const Net& net, double u) {
  const auto p = static_cast<std::size_t>(net.degree);
  const auto above = std::upper_bound(net.knots.begin(), net.knots.end(), u);
  const auto span =
      std::clamp(static_cast<std::size_t>(above - net.knots.begin()), p + 1, net.points.size()) - 1;
  std::array<Eigen::Vector4d, curves::kMaxDegree + 1> corner;
  for (std::size_t j = 0; j <= p; ++j) {
    corner[j] = net.points[span - p + j];
  }
  for (std::size_t level = 1; level <= p; ++level) {
    for (std::size_t j = p; j >= level; --j) {
      const double low = net.knots[span - p + j];
      const double high = net.knots[span + 1 + j - level];
      const double share = (u - low) / (high - low);
      corner[j] = (1.0 - share) * corner[j - 1] + share * corner[j];
    }
  }
  return corner[p];
}

ParametricPoint ParametricCurve::at(double u) const {
  u = std::clamp(u, u_begin(), u_end());
  const Eigen::Vector4d h0 = value(nets_[0], u);
  const Eigen::Vector4d h1 = value(nets_[1], u);
  const Eigen::Vector4d h2 = value(nets_[2], u);
  ParametricPoint point;
  point.at_mm = h0.head<3>() / h0[3];
  point.first = (h1.head<3>() - h1[3] * point.at_mm) / h0[3];
  point.second = (h2.head<3>() - 2.0 * h1[3] * point.first - h2[3] * point.at_mm) / h0[3];
  return point;
}

Eigen::Vector3d ParametricCurve::position_mm(double u) const {
  const Eigen::Vector4d h = value(nets_[0], std::clamp(u, u_begin(), u_end()));
  return h.head<3>() / h[3];
}

double ParametricCurve::step(double u, double way_mm) const {
  const ParametricPoint point = at(u);
  const double speed = point.first.norm();
  const double second = point.first.dot(point.second) / (2.0 * std::pow(speed, 4));
  return std::min(u + way_mm / speed - second * way_mm * way_mm, u_end());
}

double ParametricCurve::chord_error_mm(double u_from, double u_to) const {
  constexpr int kPlaces = 12;
  const Eigen::Vector3d from = position_mm(u_from);
  const Eigen::Vector3d chord = position_mm(u_to) - from;
  double farthest = 0.0;
  for (int k = 1; k < kPlaces; ++k) {
    const Eigen::Vector3d to = position_mm(u_from + (u_to - u_from) * k / kPlaces) - from;
    const double share = std::clamp(to.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    farthest = std::max(farthest, (to - share * chord).norm());
  }
  return farthest;
}

}  // namespace kerf::bench
