// A second, plain NURBS evaluator to judge the library by: Cox-de Boor basis functions in long
// double, straight from the definition [NurbsBook, equations 2.5 and 4.1].
#pragma once

#include <random>

#include <Eigen/Core>

#include "curves/nurbs_curve.hpp"

namespace kerf::curves::testing {

using Wide = long double;
using WideVector = Eigen::Matrix<Wide, 3, 1>;

WideVector reference_point_mm(const NurbsData& data, Wide u);
WideVector reference_derivative(const NurbsData& data, Wide u);
// The parameter near u where the curve passes closest to a point next to it (Newton's method).
Wide reference_parameter(const NurbsData& data, const Position& near_mm, Wide u);
// |dC/du|
Wide reference_speed(const NurbsData& data, Wide u);
// Arc length between two parameters, by adaptive Gauss quadrature between the knots.
Wide reference_length_mm(const NurbsData& data, Wide u_from, Wide u_to);

struct RandomNurbsOptions {
  int degree = 3;
  int points = 8;
  double size_mm = 100.0;
  double weight_decades = 0.0;  // weights between 10^-this and 10^this
  int max_repeats = 1;          // of an inner knot
};

NurbsData random_nurbs(std::mt19937_64& random, const RandomNurbsOptions& options);

// A clamped uniform knot vector.
std::vector<double> uniform_knots(int degree, std::size_t points);

}  // namespace kerf::curves::testing
