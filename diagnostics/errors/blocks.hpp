// Pages of what a block may hold: every word needs somebody who uses it.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kLineNumberOutOfRange{
    140,
    Severity::error,
    "line number out of range",
    "N numbers a block and has at most 8 digits.",
    "Write a smaller number, or leave N out: blocks need no numbers.",
    "N123456789 G0 X1\nM2\n"};

inline constexpr ErrorPage kTwoUsersOfP{
    141,
    Severity::error,
    "P has two users",
    "Two codes of the block take a P word (the turns of an arc, the time of G4, the tolerance of "
    "G64), and which of them it belongs to cannot be told.",
    "Give each of the two codes a block of its own.",
    "G4 G64 P0.5\nM2\n"};

inline constexpr ErrorPage kParameterOutOfRange{
    142,
    Severity::error,
    "value outside the work range",
    "Lengths may reach from -999999.999 to 999999.999 mm. Beyond that a double holds the position "
    "no longer as exactly as a machine needs it.",
    "Correct the value: a missing decimal point or two numbers run together are the usual causes.",
    "G2 X10 I9999999 F100\nM2\n"};

inline constexpr ErrorPage kIdleAxisWords{
    143,
    Severity::error,
    "axis words that the block's code does not use",
    "The block gives coordinates, but its code moves no axis. The coordinates were most likely "
    "meant for a motion.",
    "Write the motion code that was meant (G0, G1 ...), or take the axis words out.",
    "G80 X10\nM2\n"};

inline constexpr ErrorPage kDwellWithAxis{
    144,
    Severity::error,
    "dwell with an axis word",
    "G4 takes its time in P, in seconds. Fanuc and other controls also take X or U; a position in "
    "X is not what is meant here.",
    "Write the time as P.",
    "G4 X1.5\nM2\n"};

inline constexpr ErrorPage kNoMotionMode{
    145,
    Severity::error,
    "axis words without a motion mode",
    "The block gives coordinates, but no motion mode is active: none was chosen so far, or G80 or "
    "the end of a spline took it back.",
    "Write G0, G1 or another motion code in the block.",
    "X10 Y10\nM2\n"};

inline constexpr ErrorPage kUnknownAxis{
    146,
    Severity::error,
    "axis that this machine does not have",
    "The machine has the axes X, Y and Z, and of A, B, C, U, V and W those that the machine file "
    "names. A word for another axis is refused and not passed over, since the part would come out "
    "wrong without it.",
    "Make the program for a machine with three axes, or name the axis in the machine file.",
    "G0 X10 A90\nM2\n"};

inline constexpr ErrorPage kExtraAxisHere{
    151,
    Severity::error,
    "A, B, C, U, V or W where only X, Y and Z can move",
    "The machine has this axis, but it moves only with G0, G1, G2, G3, G28, G30 and G53. In "
    "splines, "
    "canned cycles and probing, under G41 and G42 and in the data of tools it cannot be used.",
    "Write the axis in a block of its own, before or after.",
    "G99 G81 X1 Z-1 R1 A90 F100\nM2\n"};

inline constexpr ErrorPage kExponent{
    148,
    Severity::error,
    "number with an exponent",
    "Numbers have digits, a sign and a decimal point, no exponent: E is an address letter. A "
    "post-processor that prints 1e-05 for a tiny number is the usual cause.",
    "Write the number out (1e-05 is 0.00001), or have the post-processor round it.",
    "G1 X1E5 F100\nM2\n"};

inline constexpr ErrorPage kExtruderWord{
    149,
    Severity::error,
    "E word",
    "E is the extruder of 3D printers and means nothing to a milling machine.",
    "Load a program that was made for a milling machine.",
    "G1 X10 E5 F100\nM2\n"};

inline constexpr ErrorPage kUnusedWord{
    150,
    Severity::error,
    "word that no code uses",
    "Each word of a block must belong to a code of that block or to the active motion. A word that "
    "nobody uses shows that something else was meant.",
    "Take the word out, or write the code that it belongs to.",
    "G0 X10 K5\nM2\n"};

inline constexpr std::array kBlocksPages{
    &kLineNumberOutOfRange, &kTwoUsersOfP,   &kParameterOutOfRange,
    &kIdleAxisWords,        &kDwellWithAxis, &kNoMotionMode,
    &kUnknownAxis,          &kExtraAxisHere, &kExponent,
    &kExtruderWord,         &kUnusedWord};

}  // namespace kerf::errors
