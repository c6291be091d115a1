// Feedrate squared over arc length as a quadratic spline: continuous feedrate and acceleration.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace kerf::lookahead {

// b = v^2 at a place: a = slope / 2, jerk = sqrt(b) bend / 2.
struct SquaredFeed {
  double value = 0.0;  // mm^2/s^2
  double slope = 0.0;  // by s, mm/s^2
  double bend = 0.0;   // by s twice, 1/s^2
};

// What each of the three coefficients that a cell depends on adds at a place.
struct Basis {
  std::array<double, 3> value{};
  std::array<double, 3> slope{};
  std::array<double, 3> bend{};

  [[nodiscard]] SquaredFeed at(const double* coefficients) const noexcept {
    const auto sum = [coefficients](const std::array<double, 3>& c) {
      return c[0] * coefficients[0] + c[1] * coefficients[1] + c[2] * coefficients[2];
    };
    return {.value = sum(value), .slope = sum(slope), .bend = sum(bend)};
  }
};

// The coefficients of the two halves of a cell on which the spline stays as it is: over a part of a
// cell the coefficient is the blossom of the cell's polynomial at the part's ends. begin: of the
// cell.
inline std::array<double, 2> coefficients_of_halves(const SquaredFeed& begin, double length_mm) {
  const double half = 0.5 * length_mm;
  return {begin.value + 0.5 * half * begin.slope,
          begin.value + 1.5 * half * begin.slope + half * half * begin.bend};
}

struct CellBasis {
  Basis begin{};
  Basis middle{};
  Basis end{};
};

// The basis functions of cells of these lengths (mm, > 0). Cell i depends on the coefficients i,
// i + 1 and i + 2; at both ends of the whole the first two and the last two fix value and slope:
// b = c_0, b' = 2 (c_1 - c_0) / first length.
std::vector<CellBasis> feed_basis(std::span<const double> lengths_mm);

}  // namespace kerf::lookahead
