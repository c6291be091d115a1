#include "tests/curves/reference_nurbs.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>

namespace kerf::curves::testing {
namespace {

using WidePoint = Eigen::Matrix<Wide, 4, 1>;

// The knot span [knots[k], knots[k + 1]) that holds u; the last one holds its end too.
std::size_t knot_span(const NurbsData& data, Wide u) {
  const auto after = std::upper_bound(data.knots.begin(), data.knots.end(), u,
                                      [](Wide a, double b) { return a < static_cast<Wide>(b); });
  const auto knot = static_cast<std::size_t>(after - data.knots.begin()) - 1;
  return std::min(knot, data.points.size() - 1);
}

// Values at u of the basis functions of this degree that do not vanish in span k: number k - degree
// and following, row by row of the triangle [NurbsBook, equation 2.5].
std::vector<Wide> basis(const std::vector<double>& knots, std::size_t k, std::size_t degree,
                        Wide u) {
  const auto knot = [&](std::size_t i) { return static_cast<Wide>(knots[i]); };
  std::vector<Wide> row{1.0L};
  for (std::size_t p = 1; p <= degree; ++p) {
    std::vector<Wide> next(p + 1, 0.0L);
    for (std::size_t j = 0; j < p; ++j) {  // function i of degree p - 1 feeds i - 1 and i
      const std::size_t i = k - (p - 1) + j;
      const Wide share = (u - knot(i)) / (knot(i + p) - knot(i));
      next[j + 1] += share * row[j];
      next[j] += (1.0L - share) * row[j];
    }
    row = std::move(next);
  }
  return row;
}

WidePoint homogeneous(const ControlPoint& point) {
  const Wide w = static_cast<Wide>(point.weight);
  return {w * static_cast<Wide>(point.position_mm[0]), w * static_cast<Wide>(point.position_mm[1]),
          w * static_cast<Wide>(point.position_mm[2]), w};
}

WidePoint value(const NurbsData& data, Wide u) {
  WidePoint sum = WidePoint::Zero();
  const auto p = static_cast<std::size_t>(data.degree);
  const std::size_t k = knot_span(data, u);
  const std::vector<Wide> n = basis(data.knots, k, p, u);
  for (std::size_t j = 0; j <= p; ++j)
    sum += n[j] * homogeneous(data.points[k - p + j]);
  return sum;
}

// [NurbsBook, equation 3.4].
WidePoint derivative(const NurbsData& data, Wide u) {
  WidePoint sum = WidePoint::Zero();
  const auto p = static_cast<std::size_t>(data.degree);
  const std::size_t k = knot_span(data, u);
  const std::vector<Wide> n = basis(data.knots, k, p - 1, u);
  for (std::size_t j = 0; j < p; ++j) {
    const std::size_t i = k - p + j;
    const Wide width =
        static_cast<Wide>(data.knots[i + p + 1]) - static_cast<Wide>(data.knots[i + 1]);
    sum += static_cast<Wide>(data.degree) / width * n[j] *
           (homogeneous(data.points[i + 1]) - homogeneous(data.points[i]));
  }
  return sum;
}

Wide rule_mm(const NurbsData& data, Wide u_from, Wide u_to) {
  return boost::math::quadrature::gauss<Wide, 20>::integrate(
      [&](Wide u) { return reference_speed(data, u); }, u_from, u_to);
}

// Halved until the halves agree with the whole to 1e-13 mm.
Wide adaptive_length_mm(const NurbsData& data, Wide u_from, Wide u_to, Wide whole_mm, int depth) {
  const Wide middle = 0.5L * (u_from + u_to);
  const Wide left_mm = rule_mm(data, u_from, middle);
  const Wide right_mm = rule_mm(data, middle, u_to);
  if (std::abs(left_mm + right_mm - whole_mm) <= 1e-13L || depth == 0)
    return left_mm + right_mm;
  return adaptive_length_mm(data, u_from, middle, left_mm, depth - 1) +
         adaptive_length_mm(data, middle, u_to, right_mm, depth - 1);
}

}  // namespace

WideVector reference_point_mm(const NurbsData& data, Wide u) {
  const WidePoint v = value(data, u);
  return v.head<3>() / v.w();
}

WideVector reference_derivative(const NurbsData& data, Wide u) {
  const WidePoint v = value(data, u);
  const WidePoint d = derivative(data, u);
  return (d.head<3>() - d.w() * (v.head<3>() / v.w())) / v.w();
}

Wide reference_parameter(const NurbsData& data, const Position& near_mm, Wide u) {
  const WideVector target_mm = vec(near_mm).cast<Wide>();
  const auto clamp = [&](Wide at) {
    return std::clamp(at, static_cast<Wide>(data.knots.front()),
                      static_cast<Wide>(data.knots.back()));
  };
  for (int step = 0; step < 30; ++step) {
    const WideVector d = reference_derivative(data, u);
    const Wide speed_squared = d.squaredNorm();
    if (!(speed_squared > 0.0L))
      break;
    u = clamp(u + d.dot(target_mm - reference_point_mm(data, u)) / speed_squared);
  }
  return u;
}

Wide reference_speed(const NurbsData& data, Wide u) {
  return reference_derivative(data, u).norm();
}

Wide reference_length_mm(const NurbsData& data, Wide u_from, Wide u_to) {
  std::vector<Wide> stops{u_from};
  for (const double knot : data.knots) {
    const Wide k = static_cast<Wide>(knot);
    if (k > stops.back() && k < u_to)
      stops.push_back(k);
  }
  stops.push_back(u_to);
  Wide sum = 0.0L;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (!(stops[i] > stops[i - 1]))
      continue;
    sum +=
        adaptive_length_mm(data, stops[i - 1], stops[i], rule_mm(data, stops[i - 1], stops[i]), 40);
  }
  return sum;
}

std::vector<double> uniform_knots(int degree, std::size_t points) {
  const auto p = static_cast<std::size_t>(degree);
  std::vector<double> knots(p + 1, 0.0);
  for (std::size_t k = p + 1; k < points; ++k)
    knots.push_back(knots.back() + 1.0);
  knots.insert(knots.end(), p + 1, knots.back() + 1.0);
  return knots;
}

NurbsData random_nurbs(std::mt19937_64& random, const RandomNurbsOptions& options) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  NurbsData data;
  data.degree = options.degree;
  for (int i = 0; i < options.points; ++i) {
    ControlPoint point;
    for (double& c : point.position_mm)
      c = options.size_mm * (unit(random) - 0.5);
    point.weight = std::pow(10.0, options.weight_decades * (2.0 * unit(random) - 1.0));
    data.points.push_back(point);
  }
  const int order = options.degree + 1;
  data.knots.assign(static_cast<std::size_t>(order), 0.0);
  int inner = options.points - order;
  while (inner > 0) {
    const int most = std::min(inner, options.max_repeats);
    const int repeats = std::uniform_int_distribution<int>(1, most)(random);
    const double next = data.knots.back() + 0.05 + unit(random);
    data.knots.insert(data.knots.end(), static_cast<std::size_t>(repeats), next);
    inner -= repeats;
  }
  const double last = data.knots.back() + 0.05 + unit(random);
  data.knots.insert(data.knots.end(), static_cast<std::size_t>(order), last);
  return data;
}

}  // namespace kerf::curves::testing
