// Pages of what only the Fanuc dialect has.
#pragma once

#include <array>

#include "parser/errors/error_page.hpp"

namespace kerf::parser::errors {

inline constexpr ErrorPage kDwellTwice{
    900,
    Severity::error,
    "two times in one G4",
    "In the Fanuc dialect G4 takes its time in P (milliseconds), or in X or U (seconds), and the "
    "block has more than one of them.",
    "Keep one of the words.",
    "G4 P500 X1.\nM2\n",
    Dialect::fanuc};

inline constexpr ErrorPage kReferencePoint{
    901,
    Severity::error,
    "no such reference point",
    "G30 P2, P3 and P4 go to the second to fourth reference point. The machine file has two: that "
    "of G28 and that of G30.",
    "Write P2, or leave P out.",
    "G30 P3 X0\nM2\n",
    Dialect::fanuc};

inline constexpr ErrorPage kOffsetMemoryValue{
    902,
    Severity::error,
    "G10 L10 to L13 without R",
    "G10 L10 (length), L11 (its wear), L12 (radius) and L13 (its wear) set offset number P to the "
    "value in R.",
    "Write R, and no axis word.",
    "G10 L10 P1 Z5.\nM2\n",
    Dialect::fanuc};

inline constexpr std::array kFanucPages{&kDwellTwice, &kReferencePoint, &kOffsetMemoryValue};

}  // namespace kerf::parser::errors
