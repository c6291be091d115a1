// Pages of the words that set modes: F, S, T, the path mode, dwells.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kNegativeFeed{
    120,
    Severity::error,
    "negative feed",
    "F is the feed along the path (or with G93 the inverse of a time) and cannot be negative.",
    "Write F without the sign.",
    "G1 X10 F-100\nM2\n"};

inline constexpr ErrorPage kFeedOutOfRange{
    121,
    Severity::error,
    "feed out of range",
    "The value of F is beyond anything that a machine can do. A missing decimal point or two "
    "numbers run together are the usual causes.",
    "Correct the value.",
    "G1 X10 F10000000000\nM2\n"};

inline constexpr ErrorPage kNegativeSpeed{
    122,
    Severity::error,
    "negative spindle speed",
    "S is a speed without a direction; M3 and M4 choose the direction.",
    "Write S without the sign, and M4 for the other direction.",
    "M3 S-1000\nM2\n"};

inline constexpr ErrorPage kSpeedOutOfRange{
    123,
    Severity::error,
    "spindle speed out of range",
    "The value of S is beyond anything that a spindle can do. A missing decimal point or two "
    "numbers run together are the usual causes.",
    "Correct the value.",
    "M3 S10000000000\nM2\n"};

inline constexpr ErrorPage kNegativeTool{
    124,
    Severity::error,
    "negative tool number",
    "T names a tool by its number, which counts from 0 (no tool).",
    "Write the number of a tool.",
    "T-1 M6\nM2\n"};

inline constexpr ErrorPage kToolNotWhole{125,
                                         Severity::error,
                                         "tool number with decimals",
                                         "T names a tool by its number, which is a whole one.",
                                         "Write the number of a tool without decimals.",
                                         "T1.5 M6\nM2\n"};

inline constexpr ErrorPage kToolOutOfRange{
    126,
    Severity::error,
    "tool number out of range",
    "The tool number has more digits than a tool number can have (at most 8).",
    "Correct the number.",
    "T123456789 M6\nM2\n"};

inline constexpr ErrorPage kToolChangeWithoutTool{
    127,
    Severity::warning,
    "tool change with no tool selected",
    "M6 changes to the tool that the last T word selected, and there was none so far. The change "
    "is passed to the machine as one to tool 0.",
    "Write T with the number of the tool before M6 or in its block.",
    "M6\nM2\n"};

inline constexpr ErrorPage kNegativeBlendTolerance{
    128,
    Severity::error,
    "negative tolerance of G64",
    "P of G64 is how far, at most, the tool may leave the programmed path at a corner.",
    "Give P a positive value; with P0 no corner is blended, and G61 keeps to the path exactly.",
    "G64 P-0.01\nM2\n"};

inline constexpr ErrorPage kNegativeMergeTolerance{
    129,
    Severity::error,
    "negative merging tolerance of G64",
    "Q of G64 is how far, at most, a run of short lines may lie from the one curve that stands in "
    "for it.",
    "Give Q a positive value; with Q0 no lines are merged.",
    "G64 P0.01 Q-0.01\nM2\n"};

inline constexpr ErrorPage kDwellWithoutTime{130,
                                             Severity::error,
                                             "dwell without a time",
                                             "G4 waits, and P says how many seconds.",
                                             "Write P with the time in seconds: G4 P0.5.",
                                             "G4\nM2\n"};

inline constexpr ErrorPage kNegativeDwell{131,
                                          Severity::error,
                                          "negative dwell",
                                          "P of G4 is a time to wait, which cannot be negative.",
                                          "Write P without the sign.",
                                          "G4 P-1\nM2\n"};

inline constexpr std::array kModesPages{
    &kNegativeFeed,           &kFeedOutOfRange,         &kNegativeSpeed,    &kSpeedOutOfRange,
    &kNegativeTool,           &kToolNotWhole,           &kToolOutOfRange,   &kToolChangeWithoutTool,
    &kNegativeBlendTolerance, &kNegativeMergeTolerance, &kDwellWithoutTime, &kNegativeDwell};

}  // namespace kerf::errors
