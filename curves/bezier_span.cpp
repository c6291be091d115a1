#include "curves/bezier_span.hpp"

#include <algorithm>
#include <cassert>

namespace kerf::curves {

Wide BezierSpan::polygon_length_mm() const {
  Wide length_mm = 0.0L;
  for (std::size_t i = 1; i < count(); ++i) {
    length_mm += (seen(i) - seen(i - 1)).norm();
  }
  return length_mm;
}

Wide BezierSpan::weight_ratio() const {
  Wide least = points[0].w();
  Wide most = least;
  for (std::size_t i = 1; i < count(); ++i) {
    least = std::min(least, points[i].w());
    most = std::max(most, points[i].w());
  }
  return most / least;
}

WideVector BezierSpan::begin_direction(Wide noise_mm) const {
  for (std::size_t i = 1; i < count(); ++i) {
    const WideVector way_mm = seen(i) - seen(0);
    const Wide length_mm = way_mm.norm();
    if (length_mm > noise_mm) {
      return way_mm / length_mm;
    }
  }
  return WideVector::Zero();
}

WideVector BezierSpan::end_direction(Wide noise_mm) const {
  const std::size_t last = count() - 1;
  for (std::size_t i = last; i-- > 0;) {
    const WideVector way_mm = seen(last) - seen(i);
    const Wide length_mm = way_mm.norm();
    if (length_mm > noise_mm) {
      return way_mm / length_mm;
    }
  }
  return WideVector::Zero();
}

std::pair<BezierSpan, BezierSpan> halve(const BezierSpan& span) {
  const std::size_t count = span.count();
  BezierSpan left;
  BezierSpan right;
  left.degree = right.degree = span.degree;
  left.u_begin = span.u_begin;
  left.u_end = right.u_begin = 0.5L * (span.u_begin + span.u_end);
  right.u_end = span.u_end;
  std::array<WidePoint, kMaxDegree + 1> row = span.points;
  for (std::size_t level = 0; level < count; ++level) {
    left.points[level] = row[0];
    right.points[count - 1 - level] = row[count - 1 - level];
    for (std::size_t i = 0; i + level + 1 < count; ++i) {
      row[i] = 0.5L * (row[i] + row[i + 1]);
    }
  }
  const WideVector middle_mm = right.seen(0);
  left.origin_mm = right.origin_mm = span.origin_mm + middle_mm;
  for (std::size_t i = 0; i < count; ++i) {
    left.points[i].head<3>() -= left.points[i].w() * middle_mm;
    right.points[i].head<3>() -= right.points[i].w() * middle_mm;
  }
  return {left, right};
}

std::array<WidePoint, kMaxDegree + 1> taylor_at_begin(const BezierSpan& span) {
  const std::size_t count = span.count();
  std::array<WidePoint, kMaxDegree + 1> differences = span.points;
  Wide binomial = 1.0L;
  for (std::size_t k = 1; k < count; ++k) {
    for (std::size_t i = count - 1; i >= k; --i) {
      differences[i] -= differences[i - 1];
    }
  }
  for (std::size_t k = 1; k < count; ++k) {
    binomial *= static_cast<Wide>(count - k) / static_cast<Wide>(k);
    differences[k] *= binomial;
  }
  return differences;
}

// Powers about x = -1 with t = (x + 1) / 2 in [0, 1], divided by the binomials, are the differences
// of the control points.
BezierSpan from_powers(const std::array<WidePoint, kMaxDegree + 1>& power, int degree) {
  assert(1 <= degree && degree <= kMaxDegree);
  BezierSpan span;
  span.degree = degree;
  span.points = power;
  auto& b = span.points;
  const std::size_t count = span.count();
  for (std::size_t round = 0; round + 1 < count; ++round) {
    for (std::size_t k = count - 1; k > round; --k) {
      b[k - 1] -= b[k];
    }
  }
  Wide factor = 1.0L;  // 2^k / binomial(degree, k)
  for (std::size_t k = 0; k < count; ++k) {
    b[k] *= factor;
    if (k + 1 < count) {
      factor *= 2.0L * static_cast<Wide>(k + 1) / static_cast<Wide>(count - 1 - k);
    }
  }
  for (std::size_t round = 1; round < count; ++round) {
    for (std::size_t i = count - 1; i >= round; --i) {
      b[i] += b[i - 1];
    }
  }
  return span;
}

}  // namespace kerf::curves
