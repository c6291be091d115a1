// Pages of what only the Fanuc dialect has.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kDwellTwice{
    900,
    Severity::error,
    "two times in one G4",
    "In the Fanuc dialect G4 takes its time in P (milliseconds), or in X or U (seconds), and the "
    "block has more than one of them.",
    "Keep one of the words.",
    "G4 P500 X1.\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kReferencePoint{
    901,
    Severity::error,
    "no such reference point",
    "G30 P2, P3 and P4 go to the second to fourth reference point; the first is that of G28.",
    "Write P2, P3 or P4, or leave P out for P2.",
    "G30 P5 X0\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kOffsetMemoryValue{
    902,
    Severity::error,
    "G10 L10 to L13 without R",
    "G10 L10 (length), L11 (its wear), L12 (radius) and L13 (its wear) set offset number P to the "
    "value in R.",
    "Write R, and no axis word.",
    "G10 L10 P1 Z5.\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kSemicolonEndsBlock{
    903,
    Severity::warning,
    "more than one block in a line",
    "In the Fanuc dialect ';' ends a block where words follow it; in RS274 it begins a comment. "
    "The "
    "words behind it are run as a block of their own.",
    "Write each block on a line of its own, or the remark in brackets.",
    "G1 X5. F100; G1 Y7.;\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kBlockBehindCall{
    904,
    Severity::error,
    "block behind a call in one line",
    "The subprogram runs behind the line that calls it, so a block that follows the call in the "
    "same line would come too early.",
    "Write the block on a line of its own.",
    "M98 P100; G0 X5\nM30\nO100\nG0 X1\nM99\n",
    "fanuc"};

inline constexpr ErrorPage kOrderExtension{
    905,
    Severity::warning,
    "order of a curve above Fanuc's",
    "Fanuc's G06.2 takes P (order, degree + 1) from 2 to 4 and answers others with PS5115. Kerf "
    "runs "
    "orders up to 10.",
    "Nothing to mend for Kerf. For a Fanuc control let the CAM system write curves of order 4.",
    "G6.2 P5 K0 X0 Y0 F100\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kTooManyModalCalls{
    906,
    Severity::error,
    "too many modal calls",
    "Each G66 adds a macro to those that a move calls, and G67 takes the last one away again. Four "
    "may be in force.",
    "Cancel each G66 with a G67, in loops too.",
    "G66 P1\nG66 P1\nG66 P1\nG66 P1\nG66 P1\nM30\nO1\nM99\n",
    "fanuc"};

inline constexpr ErrorPage kProgramGivenTwice{
    907,
    Severity::error,
    "program called by name and by number",
    "M98, G65 and G66 call the program <NAME>, or the one whose number is in P, not both.",
    "Keep the name or P.",
    "M98 <POCKET> P100\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kRoundInAddress{
    908,
    Severity::error,
    "ROUND in an address",
    "In a statement like `#1=ROUND[#2]` ROUND gives a whole number. In the value of an address "
    "Fanuc rounds to the address's least increment instead, which depends on the control, and "
    "Kerf does not.",
    "Round in a statement before: `#101=ROUND[#1*1000]/1000` and `X#101` for three decimals. "
    "Addresses that take whole numbers (G, M, P, T ...) may have ROUND.",
    "G0 X[ROUND[#1]]\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kNoDecimalPoint{
    909,
    Severity::warning,
    "coordinate without a decimal point",
    "Many Fanuc controls count numbers without a decimal point in their least increment: X10 is "
    "0.010 mm there. Kerf reads millimetres or inches unless the machine file says "
    "`least_increment_mm`. This is said once for a program, at the first such word of a "
    "straight cut, an arc or a cycle; 0 is the same either way.",
    "Write the point (X10.), or set `[program] least_increment_mm` as the control has it.",
    "G1 X10 F100\nM30\n",
    "fanuc"};

inline constexpr std::array kFanucPages{
    &kNoDecimalPoint, &kTooManyModalCalls,  &kProgramGivenTwice, &kRoundInAddress,
    &kOrderExtension, &kSemicolonEndsBlock, &kBlockBehindCall,   &kDwellTwice,
    &kReferencePoint, &kOffsetMemoryValue};

}  // namespace kerf::errors
