// A NURBS by its parameter, as the papers walk it.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "curves/nurbs_curve.hpp"

namespace kerf::bench {

struct ParametricPoint {
  Eigen::Vector3d at_mm;
  Eigen::Vector3d first;   // by u
  Eigen::Vector3d second;  // by u twice
};

class ParametricCurve {
 public:
  // Precondition: NurbsCurve::make takes the data.
  explicit ParametricCurve(const curves::NurbsData& data);

  [[nodiscard]] double u_begin() const { return nets_[0].knots.front(); }
  [[nodiscard]] double u_end() const { return nets_[0].knots.back(); }
  // u is clamped.
  [[nodiscard]] ParametricPoint at(double u) const;
  [[nodiscard]] Eigen::Vector3d position_mm(double u) const;
  // The parameter that a step of the given length along the path leads to, by Taylor's series of
  // second order [Sigmoid, equation 16]; at most u_end().
  [[nodiscard]] double step(double u, double way_mm) const;
  // The largest distance of the curve from the chord between two parameters.
  [[nodiscard]] double chord_error_mm(double u_from, double u_to) const;

 private:
  // Homogeneous control points, of the curve and of its derivatives.
  struct Net {
    int degree = 0;
    std::vector<Eigen::Vector4d> points;
    std::vector<double> knots;
  };
  [[nodiscard]] static Net derivative_of(const Net& net);
  [[nodiscard]] static Eigen::Vector4d value(const Net& net, double u);

  std::vector<Net> nets_;
};

}  // namespace kerf::bench
