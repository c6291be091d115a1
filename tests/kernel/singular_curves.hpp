// Curves at the edge of what a NURBS can be, and the programs that run them.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "curves/nurbs_curve.hpp"
#include "lookahead/path/limits.hpp"
#include "tests/kernel/random_program.hpp"

namespace kerf::test {

struct SingularCurve {
  std::string name;
  curves::NurbsData data;
};

// Near-cusps down to a true one, doubling back, weights of six decades, derivatives of zero at the
// ends, knots repeated down to C0, |C'| falling by 1e6, degrees 1 to 9, 1000 control points.
const std::vector<SingularCurve>& singular_curves();

// Any degree, knots repeated and uneven, weights of up to six decades, control points that are
// nearly on a line or nearly coincide, of 1e-3 to 1e3 mm.
curves::NurbsData random_singular_curve(std::mt19937_64& random);

// Runs to the curve's begin and along it.
std::string program_of(const curves::NurbsData& data, double feedrate_mm_s);

// The numbers that it holds, to its decimals.
curves::NurbsData printed(const curves::NurbsData& data);

struct SingularCase {
  curves::NurbsData data;
  lookahead::PlanLimits limits;
  double feedrate_mm_s = 0.0;
};

// A random curve, limits of each axis that, for every other seed, spread over four decades, and a
// feedrate of eight, as far as the curve then takes no more than some longest_s.
SingularCase random_singular_case(std::uint64_t seed, double longest_s = 500.0);

// Its program, with the curve as dense points.
RandomProgram curve_program(const SingularCase& made);

}  // namespace kerf::test
