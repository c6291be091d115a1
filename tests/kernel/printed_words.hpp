// Numbers as a part program holds them, and what a control reads from that.
#pragma once

#include <string>

#include "tests/kernel/program_path.hpp"

namespace kerf::test {

// Appends x with seven decimals; what they say.
double print_number(double x, std::string& text);
// Appends the axis words of a place; the place that they name.
Vec print_axes(const Vec& to_mm, std::string& text);

}  // namespace kerf::test
