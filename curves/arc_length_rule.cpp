#include "curves/arc_length_rule.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace kerf::curves {
namespace {

using Wide = long double;
constexpr int kNodes = ArcLengthRule::kNodes;
using Legendre = std::array<Wide, kNodes + 1>;

// P_0(x) to P_kNodes(x) by the three-term recurrence.
Legendre legendre(Wide x) {
  Legendre p{};
  p[0] = 1.0L;
  p[1] = x;
  for (std::size_t k = 1; k < kNodes; ++k) {
    const Wide n = static_cast<Wide>(k);
    p[k + 1] = ((2.0L * n + 1.0L) * x * p[k] - n * p[k - 1]) / (n + 1.0L);
  }
  return p;
}

// Integral from -1 to x of P_k.
Wide integral(const Legendre& at_x, std::size_t k) {
  if (k == 0) {
    return at_x[1] + 1.0L;
  }
  return (at_x[k + 1] - at_x[k - 1]) / (2.0L * static_cast<Wide>(k) + 1.0L);
}

}  // namespace

ArcLengthRule::ArcLengthRule() {
  constexpr Wide kCount = kNodes;
  std::array<Legendre, kNodes> at_node{};
  std::array<Wide, kNodes> node_weight{};
  for (std::size_t i = 0; i < kNodes; ++i) {
    Wide x = -std::cos(std::numbers::pi_v<Wide> * (static_cast<Wide>(i) + 0.75L) / (kCount + 0.5L));
    Wide slope = 1.0L;
    for (int step = 0; step < 12; ++step) {
      const Legendre p = legendre(x);
      slope = kCount * (p[kNodes - 1] - x * p[kNodes]) / (1.0L - x * x);
      x -= p[kNodes] / slope;
    }
    at_node[i] = legendre(x);
    node_weight[i] = 2.0L / ((1.0L - x * x) * slope * slope);
    nodes[static_cast<Eigen::Index>(i)] = static_cast<double>(x);
    weights[static_cast<Eigen::Index>(i)] = static_cast<double>(node_weight[i]);
  }

  const auto coefficient_weight = [&](std::size_t k, std::size_t i) {
    return (static_cast<Wide>(k) + 0.5L) * node_weight[i] * at_node[i][k];
  };
  const auto integral_weight = [&](const Legendre& at_x, std::size_t i) {
    Wide sum = 0.0L;
    for (std::size_t k = 0; k < kNodes; ++k) {
      sum += coefficient_weight(k, i) * integral(at_x, k);
    }
    return static_cast<double>(sum);
  };
  const auto fill = [&](auto& matrix, const auto& points) {
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      const Legendre at_x = legendre(static_cast<Wide>(points[row]));
      for (Eigen::Index i = 0; i < kNodes; ++i) {
        matrix(row, i) = integral_weight(at_x, static_cast<std::size_t>(i));
      }
    }
  };
  for (Eigen::Index j = 0; j < kKnots; ++j) {
    knots[j] = -std::cos(std::numbers::pi * static_cast<double>(j) / (kKnots - 1));
  }
  for (Eigen::Index j = 0; j < kChecks; ++j) {
    checks[j] = -std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / (kKnots - 1));
  }
  fill(to_knots, knots);
  fill(to_checks, checks);
  for (Eigen::Index row = 0; row < kTail; ++row) {
    for (Eigen::Index i = 0; i < kNodes; ++i) {
      to_tail(row, i) = static_cast<double>(coefficient_weight(
          static_cast<std::size_t>(kNodes - kTail + row), static_cast<std::size_t>(i)));
    }
  }
}

const ArcLengthRule& ArcLengthRule::get() {
  static const ArcLengthRule kRule;
  return kRule;
}

}  // namespace kerf::curves
