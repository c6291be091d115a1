// Pages of canned cycles.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kCycleWithoutAxis{
    800,
    Severity::error,
    "canned cycle without an axis word",
    "A canned cycle drills where its block has an axis word; a block with its code, R, I, J"
    " or K and no X, Y or Z says no place.",
    "Write the hole's place in the block. R, Z, Q and P hold until the cycle ends and can "
    "change only where a hole is made.",
    "F100\nG81 R2\nM2\n"};

inline constexpr ErrorPage kCycleWithoutClearance{
    801,
    Severity::error,
    "canned cycle without R",
    "R is the height at which a rapid becomes a feed. It must be in the first block of a "
    "cycle, also where another cycle was active before.",
    "Write R in the block.",
    "F100\nG0 Z5\nG81 X5 Y5 Z-5\nM2\n"};

inline constexpr ErrorPage kCycleWithoutBottom{
    802,
    Severity::error,
    "canned cycle without the bottom of the hole",
    "The word of the drilling axis (Z in G17, Y in G18, X in G19) says how deep the hole "
    "is. It must be in the first block of a cycle.",
    "Write the depth in the block.",
    "F100\nG0 Z5\nG81 X5 Y5 R1\nM2\n"};

inline constexpr ErrorPage kCycleWithoutPeck{803,
                                             Severity::error,
                                             "peck drilling without Q",
                                             "G73 and G83 go down in pecks of the depth Q.",
                                             "Write Q greater than 0, or use G81.",
                                             "F100\nG0 Z5\nG83 X5 Y5 Z-5 R1\nM2\n"};

inline constexpr ErrorPage kCycleWithoutDwell{
    804,
    Severity::error,
    "cycle with a dwell but without P",
    "G82, G86, G88 and G89 wait at the bottom for P seconds.",
    "Write P (P0 does not wait), or use G81 or G85.",
    "F100\nG0 Z5\nG82 X5 Y5 Z-5 R1\nM2\n"};

inline constexpr ErrorPage kCyclePeckNotPositive{
    805,
    Severity::error,
    "Q of a peck is not greater than 0",
    "With pecks of no depth the bottom would never be reached.",
    "Write Q greater than 0; it is a depth without a sign.",
    "F100\nG0 Z5\nG83 X5 Y5 Z-5 R1 Q0\nM2\n"};

inline constexpr ErrorPage kCycleNegativeDwell{806,
                                               Severity::error,
                                               "negative dwell in a cycle",
                                               "P is how long the tool waits at the bottom.",
                                               "Write P as 0 or more.",
                                               "F100\nG0 Z5\nG82 X5 Y5 Z-5 R1 P-1\nM2\n"};

inline constexpr ErrorPage kCycleClearanceBelowBottom{
    807,
    Severity::error,
    "R below the bottom of the hole",
    "The tool goes down from R to the bottom. A bottom above R usually is the Z of a move "
    "that was meant as G0 while a cycle is still active.",
    "Correct R or the bottom; end the cycle with G80 before other moves.",
    "F100\nG0 Z5\nG81 X5 Y5 Z-1 R-3\nM2\n"};

inline constexpr ErrorPage kCycleRepeats{
    808,
    Severity::error,
    "repeats of a cycle not a whole number",
    "L (K in the Fanuc dialect) says how many holes the block makes.",
    "Write a whole number, 1 or more.",
    "F100\nG0 Z5\nG81 X5 Y5 Z-1 R1 L1.5\nM2\n"};

inline constexpr ErrorPage kCycleZeroRepeats{
    809,
    Severity::warning,
    "no repeats: nothing is drilled",
    "With L0 the block stores the words of the cycle and neither moves nor drills. LinuxCNC"
    " refuses it.",
    "Write L1 or leave L out where a hole is wanted.",
    "F100\nG0 Z5\nG81 X5 Y5 Z-1 R1 L0\nM2\n"};

inline constexpr ErrorPage kCycleTooLong{
    810,
    Severity::error,
    "more moves in one block than can be kept",
    "A block with repeats or pecks is kept as its moves, of which there may be 200000.",
    "Write a greater Q, or fewer repeats in more blocks.",
    "F100\nG0 Z5\nG83 X5 Y5 Z-5 R1 Q0.00001\nM2\n"};

inline constexpr ErrorPage kCycleInverseTime{
    811,
    Severity::error,
    "canned cycle with inverse time feed",
    "With G93 F is the time that a block takes, which says nothing of the moves within a "
    "cycle.",
    "Write G94 (feed per minute) or G95 (feed per revolution) before the cycle.",
    "G93\nG81 X5 Y5 Z-5 R1 F2\nM2\n"};

inline constexpr ErrorPage kCycleSpindle{
    812,
    Severity::error,
    "cycle needs a running spindle",
    "G84 cuts a right-hand thread and needs M3, G74 a left-hand one and needs M4; G86, G87 "
    "and G88 stop the spindle in the hole and start it again as it was.",
    "Start the spindle before the cycle.",
    "F100 S500\nG0 Z5\nG84 X5 Y5 Z-5 R1\nM2\n"};

inline constexpr ErrorPage kBackBoreWordMissing{
    813,
    Severity::error,
    "back boring without I, J or K",
    "G87 needs all three: two say how far the tool steps aside to pass the hole, that of "
    "the drilling axis where the boring upwards ends.",
    "Write I, J and K in the block.",
    "F100 S500 M3\nG0 Z5\nG87 X5 Y5 Z-5 R1 I1 J0\nM2\n"};

inline constexpr ErrorPage kHomeInCycle{
    814,
    Severity::error,
    "G28 or G30 while a canned cycle is active",
    "The block after the return would drill at once. Fanuc refuses this too (PS0044).",
    "Write G80 before the return, or G0 in its block.",
    "F100\nG0 Z5\nG81 X5 Y5 Z-5 R1\nG28 X0\nM2\n"};

inline constexpr ErrorPage kFanucBackBore{
    815,
    Severity::error,
    "G87 in Fanuc's form",
    "On Fanuc G87 shifts by Q along a direction that a parameter of the control gives, "
    "which the program does not tell.",
    "Write the moves out, or use the RS274 dialect with I, J and K.",
    "S500 M3\nG87 X5 Y5 Z-5 R1 F100\nM2\n",
    "fanuc"};

inline constexpr std::array kCyclesPages{
    &kCycleWithoutAxis,  &kCycleWithoutClearance, &kCycleWithoutBottom, &kCycleWithoutPeck,
    &kCycleWithoutDwell, &kCyclePeckNotPositive,  &kCycleNegativeDwell, &kCycleClearanceBelowBottom,
    &kCycleRepeats,      &kCycleZeroRepeats,      &kCycleTooLong,       &kCycleInverseTime,
    &kCycleSpindle,      &kBackBoreWordMissing,   &kHomeInCycle,        &kFanucBackBore};

}  // namespace kerf::errors
