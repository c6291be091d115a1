#include "smoothing/spline_fit.hpp"

#include <algorithm>
#include <cassert>
#include <functional>

#include "smoothing/normal_equations.hpp"

namespace kerf::smoothing {

namespace {

// Of a span's weight: enough to decide what no sample decides, and nothing that samples feel.
constexpr double kStiffness = 1e-13;

// Row j: the basis function that is the j-th from the left on the span, as powers of x.
using SpanBasis = Eigen::Matrix<double, kOrder, kOrder, Eigen::RowMajor>;

// By the recursion of Cox and de Boor, on polynomials. t: the knots around span k, which lies
// between t[k + 5] and t[k + 6].
SpanBasis basis_of(const std::vector<double>& t, std::size_t k) {
  const std::size_t left = k + kFitDegree;
  const double middle = 0.5 * (t[left] + t[left + 1]);
  const double half = 0.5 * (t[left + 1] - t[left]);
  SpanBasis basis = SpanBasis::Zero();
  basis(0, 0) = 1.0;
  for (std::size_t p = 1; p <= kFitDegree; ++p) {
    SpanBasis next = SpanBasis::Zero();
    // Function j of degree p - 1 begins in knot left - (p - 1) + j.
    for (std::size_t j = 0; j < p; ++j) {
      const std::size_t first = left + 1 + j - p;
      const double from = t[first];
      const double to = t[first + p];
      const double inverse = 1.0 / (to - from);
      for (std::size_t i = 0; i < p; ++i) {
        const auto row = static_cast<Eigen::Index>(j);
        const auto column = static_cast<Eigen::Index>(i);
        const double c = basis(row, column) * inverse;
        // (u - from) goes to function j + 1, (to - u) to function j, of degree p.
        next(row + 1, column) += (middle - from) * c;
        next(row + 1, column + 1) += half * c;
        next(row, column) += (to - middle) * c;
        next(row, column + 1) -= half * c;
      }
    }
    basis = next;
  }
  return basis;
}

Powers powers_of(double x) {
  const double x2 = x * x;
  const double x3 = x2 * x;
  return (Powers() << 1.0, x, x2, x3, x2 * x2, x3 * x2).finished();
}

std::vector<double> knots_of(std::span<const double> breaks_mm) {
  std::vector<double> knots(kFitDegree, breaks_mm.front());
  knots.reserve(breaks_mm.size() + 2 * kFitDegree);
  knots.insert(knots.end(), breaks_mm.begin(), breaks_mm.end());
  knots.insert(knots.end(), kFitDegree, breaks_mm.back());
  return knots;
}

// What the derivatives at the begin make of the first coefficients: of the m-th only the first
// m + 1 functions have any.
std::array<Eigen::Vector3d, kFitDegree> first_coefficients(const SpanBasis& basis, double half_mm,
                                                           const SplineTail& tail,
                                                           const Eigen::Vector3d& origin) {
  SpanBasis derived = basis;  // by x
  double scale = 1.0;
  std::array<Eigen::Vector3d, kFitDegree> c{};
  for (std::size_t m = 0; m < kFitDegree; ++m) {
    // At x = -1: powers with alternating signs.
    std::array<double, kOrder> values{};
    for (std::size_t j = 0; j <= m; ++j) {
      double sign = 1.0;
      for (std::size_t k = 0; k < kOrder; ++k) {
        values[j] += sign * derived(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k));
        sign = -sign;
      }
    }
    Eigen::Vector3d right = scale * tail.derivatives[m];
    scale *= half_mm;
    if (m == 0) {
      right -= origin;
    }
    for (std::size_t j = 0; j < m; ++j) {
      right -= values[j] * c[j];
    }
    c[m] = right / values[m];
    for (std::size_t k = 0; k + 1 < kOrder; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      derived.col(column) = static_cast<double>(k + 1) * derived.col(column + 1);
    }
    derived.col(kFitDegree).setZero();
  }
  return c;
}

// The coefficients that are known. An end coefficient and the one beside it are a fifth of the span
// apart where the first derivative is 1.
void fix_ends(std::span<const double> breaks_mm, const SpanBasis& first_basis, const FitEnds& ends,
              const Eigen::Vector3d& origin, FitEquations& equations) {
  const std::size_t spans = breaks_mm.size() - 1;
  const double first_mm = breaks_mm[1] - breaks_mm[0];
  if (ends.tail) {
    const auto first = first_coefficients(first_basis, 0.5 * first_mm, *ends.tail, origin);
    for (std::size_t i = 0; i < kFitDegree; ++i) {
      equations.fix(i, first[i]);
    }
  } else {
    const Eigen::Vector3d begin = curves::vec(ends.begin_mm) - origin;
    equations.fix(0, begin);
    if (ends.begin_direction) {
      equations.fix(1, begin + first_mm / static_cast<double>(kFitDegree) * *ends.begin_direction);
    }
  }
  if (ends.end_mm) {
    const std::size_t last = spans + kFitDegree - 1;
    const Eigen::Vector3d end = curves::vec(*ends.end_mm) - origin;
    equations.fix(last, end);
    if (ends.end_direction) {
      assert(!ends.tail || spans > 1);
      const double last_mm = breaks_mm[spans] - breaks_mm[spans - 1];
      equations.fix(last - 1,
                    end - last_mm / static_cast<double>(kFitDegree) * *ends.end_direction);
    }
  }
}

}  // namespace

Eigen::Vector3d FitSpan::at(double w_mm) const {
  const double x = local(w_mm);
  Eigen::RowVector3d value = powers.row(kFitDegree);
  for (Eigen::Index k = kFitDegree; k-- > 0;) {
    value = value * x + powers.row(k);
  }
  return value.transpose();
}

Eigen::Vector3d FitSpan::derivative(double w_mm) const {
  const double x = local(w_mm);
  Eigen::RowVector3d value = Eigen::RowVector3d::Zero();
  for (Eigen::Index k = kFitDegree; k > 0; --k) {
    value = value * x + static_cast<double>(k) * powers.row(k);
  }
  return 2.0 / (w_end_mm - w_begin_mm) * value.transpose();
}

double FitSpan::bend_bound_per_mm() const {
  double bound = 0.0;
  for (Eigen::Index k = 2; k <= static_cast<Eigen::Index>(kFitDegree); ++k) {
    bound += static_cast<double>(k * (k - 1)) * powers.row(k).norm();
  }
  const double scale = 2.0 / (w_end_mm - w_begin_mm);
  return bound * scale * scale;
}

curves::BezierSpan FitSpan::bezier() const {
  std::array<curves::WidePoint, curves::kMaxDegree + 1> power{};
  for (std::size_t k = 0; k <= kFitDegree; ++k) {
    power[k].setZero();
    if (k > 0) {
      power[k].head<3>() =
          powers.row(static_cast<Eigen::Index>(k)).transpose().cast<curves::Wide>();
    }
  }
  power[0].w() = 1.0L;
  curves::BezierSpan span = curves::from_powers(power, kFitDegree);
  span.u_begin = static_cast<curves::Wide>(w_begin_mm);
  span.u_end = static_cast<curves::Wide>(w_end_mm);
  span.origin_mm = powers.row(0).transpose().cast<curves::Wide>();
  return span;
}

SplineTail SplineFit::tail_after(std::size_t count) const {
  assert(0 < count && count <= spans.size());
  const FitSpan& last = spans[count - 1];
  SplineTail tail;
  tail.span_mm = last.w_end_mm - last.w_begin_mm;
  Eigen::Matrix<double, kOrder, 3> derived = last.powers;  // at x = 1: the sum
  double scale = 1.0;
  for (std::size_t m = 0; m < kFitDegree; ++m) {
    tail.derivatives[m] = scale * derived.colwise().sum().transpose();
    scale *= 2.0 / tail.span_mm;
    for (std::size_t k = 0; k + 1 < kOrder; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      derived.row(row) = static_cast<double>(k + 1) * derived.row(row + 1);
    }
    derived.row(kFitDegree).setZero();
  }
  return tail;
}

SplineFit fit_spline(std::span<const double> breaks_mm, std::span<const FitSample> samples,
                     const FitEnds& ends) {
  assert(breaks_mm.size() >= 2 &&
         std::ranges::adjacent_find(breaks_mm, std::greater_equal{}) == breaks_mm.end());
  assert(std::ranges::is_sorted(samples, {}, &FitSample::w_mm));
  assert(samples.empty() ||
         (breaks_mm.front() <= samples.front().w_mm && samples.back().w_mm <= breaks_mm.back()));
  const std::size_t spans = breaks_mm.size() - 1;
  SplineFit fit;
  const std::vector<double> knots = knots_of(breaks_mm);
  std::vector<SpanBasis> bases;
  bases.reserve(spans);
  FitEquations equations(spans + kFitDegree);
  // Seen from here numbers are small.
  const Eigen::Vector3d origin = curves::vec(samples.front().point_mm);
  std::size_t next = 0;
  for (std::size_t k = 0; k < spans; ++k) {
    bases.push_back(basis_of(knots, k));
    const FitSpan span{.w_begin_mm = breaks_mm[k], .w_end_mm = breaks_mm[k + 1]};
    const bool last = k + 1 == spans;
    while (next < samples.size() && (last || samples[next].w_mm < span.w_end_mm)) {
      const FitSample& sample = samples[next++];
      const Powers values = bases.back() * powers_of(span.local(sample.w_mm));
      equations.add(k, values, sample.weight, curves::vec(sample.point_mm) - origin);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      equations.stiffen(k + i, kStiffness * (span.w_end_mm - span.w_begin_mm));
    }
  }
  fix_ends(breaks_mm, bases.front(), ends, origin, equations);
  const std::vector<Eigen::Vector3d> coefficients = equations.solve();
  for (std::size_t k = 0; k < spans; ++k) {
    FitSpan& span = fit.spans.emplace_back();
    span.w_begin_mm = breaks_mm[k];
    span.w_end_mm = breaks_mm[k + 1];
    Eigen::Matrix<double, kOrder, 3> c;
    for (std::size_t i = 0; i < kOrder; ++i) {
      c.row(static_cast<Eigen::Index>(i)) = coefficients[k + i].transpose();
    }
    span.powers = bases[k].transpose() * c;
    span.powers.row(0) += origin.transpose();
  }
  return fit;
}

}  // namespace kerf::smoothing
