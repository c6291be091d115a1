// Pages of the feed of a cutting move and of straight moves.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kInverseTimeWithoutFeed{
    200,
    Severity::error,
    "no F in a block of inverse time",
    "With G93 the F word says how long its own block takes, so it does not carry over: every "
    "cutting block needs one.",
    "Give the block an F word, or go back to feed per minute with G94.",
    "G93 G1 X10 F2\nX20\nM2\n"};

inline constexpr ErrorPage kInverseTimeZeroFeed{
    201,
    Severity::error,
    "F0 in a block of inverse time",
    "With G93 a block takes 1/F minutes; F0 would take for ever.",
    "Write F greater than 0, or go back to feed per minute with G94.",
    "G93 G1 X10 F0\nM2\n"};

inline constexpr ErrorPage kNoFeed{
    202,
    Severity::error,
    "no feed set",
    "A cutting move (G1, G2, G3, a spline) needs a feed, and no F word was given so far. A change "
    "between G93, G94 and G95 forgets the feed.",
    "Write F in this block or before it.",
    "G1 X10\nM2\n"};

inline constexpr ErrorPage kZeroFeed{
    203,
    Severity::error,
    "feed is zero",
    "The feed in force is F0, at which a cutting move would never end.",
    "Write F greater than 0 in this block or before it.",
    "F0\nG1 X10\nM2\n"};

inline constexpr ErrorPage kFeedFromOtherUnits{
    204,
    Severity::warning,
    "the feed was set in the other units",
    "Between the F word and this move the program changed between inch (G20) and millimetres "
    "(G21). The feed keeps the speed that it had when it was written; other controls may read the "
    "old number in the new units, which is 25.4 times as much or as little.",
    "Write F again after G20 or G21.",
    "G21 F100\nG20\nG1 X1\nM2\n"};

inline constexpr ErrorPage kMachineMotionMode{
    210,
    Severity::error,
    "G53 without G0 or G1",
    "G53 takes the coordinates of its block as those of the machine. It works with straight moves "
    "only, since the centre of an arc would have no clear meaning.",
    "Write G0 or G1 in the block.",
    "G2 X10 Y0 I5 F100\nG53 X0 Y0 I-5\nM2\n"};

inline constexpr ErrorPage kMachineIncremental{
    211,
    Severity::error,
    "G53 with incremental distances",
    "G53 names a place of the machine; with G91 the words are distances and name no place.",
    "Write G90 before the block or in it.",
    "G91\nG53 G0 X10\nM2\n"};

inline constexpr ErrorPage kMachineWithoutAxis{
    212,
    Severity::error,
    "G53 without an axis word",
    "G53 holds for its own block only, so without coordinates in it there is nothing to do.",
    "Give the block X, Y or Z, or take G53 out. It is not a mode: each block needs its own.",
    "G53 G0\nM2\n"};

inline constexpr ErrorPage kPositionOutOfRange{
    213,
    Severity::error,
    "position outside the work range",
    "The move leads to a coordinate beyond -999999.999 to 999999.999 mm, which is larger than any "
    "machine and which a double no longer holds exactly.",
    "Correct the value: a missing decimal point or two numbers run together are the usual causes.",
    "G0 X1000000\nM2\n"};

inline constexpr std::array kMotionPages{&kInverseTimeWithoutFeed,
                                         &kInverseTimeZeroFeed,
                                         &kNoFeed,
                                         &kZeroFeed,
                                         &kFeedFromOtherUnits,
                                         &kMachineMotionMode,
                                         &kMachineIncremental,
                                         &kMachineWithoutAxis,
                                         &kPositionOutOfRange};

}  // namespace kerf::errors
