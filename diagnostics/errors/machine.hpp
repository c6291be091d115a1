// Pages of what the machine cannot do, found once the text is understood.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kOutsideTravel{
    1000,
    Severity::error,
    "path outside the travel",
    "The path of the block, bulges of arcs and splines included, leaves the travel of an axis as "
    "the machine file gives it. The program is not started.",
    "See whether the work offset and the units (G20, G21) are those that the program was made "
    "for. If they are, the part must be clamped elsewhere, or needs a larger machine.",
    "G0 X100000\nM2\n"};

inline constexpr ErrorPage kCurveRefused{
    1001,
    Severity::error,
    "curve that cannot be run",
    "Each word of the block is right, but the curve that they give together cannot be followed: "
    "an arc whose centre is its end, a spiral of very many turns, points beyond 1e9 mm.",
    "Correct the points or radii that the message names.",
    "G2 X0.01 Y0 I0.01 F100\nM2\n"};

inline constexpr ErrorPage kMachineWithoutLimit{
    1002,
    Severity::error,
    "machine without a limit",
    "A motion needs a limit of velocity, acceleration and jerk along its path, and the machine "
    "that the embedding program gave leaves one open. The program is not started. A machine file "
    "that does is refused before.",
    "Give the machine the limit that the message names.",
    "G0 X1\nM2\n"};

inline constexpr ErrorPage kTooLong{
    1003,
    Severity::error,
    "program that takes too long",
    "The program has run for longer than is allowed, or must have by the length of its path, and "
    "has not ended: a loop may have no end, or a feedrate be a thousand times too small.",
    "See whether the loop around the block ends and whether F is in the unit that is in force "
    "(G20, G21, G93 to G95). Allow a program that does take that long its time with --max-time.",
    "o100 while [1]\nG0 X1\nG0 X0\no100 endwhile\nM2\n"};

inline constexpr ErrorPage kImpossibleSetting{
    1004,
    Severity::error,
    "impossible setting",
    "A program that embeds the kernel gave it a machine or options with a value that nothing can "
    "be "
    "planned with: a limit of 0, a negative jerk, a horizon that is no time. The program is not "
    "started. A machine file with such a value is refused before.",
    "Give the setting that the message names a value from the range that it names.",
    "G0 X1\nM2\n"};

inline constexpr ErrorPage kFeedBeyondReach{
    1010,
    Severity::warning,
    "feed out of the machine's reach",
    "The feed is higher than the velocity limits of path and axes allow in any direction. The "
    "limits hold, so the block runs slower than it asks for. Said once, of the first such block.",
    "Write a feed that the machine can reach; see whether the units (G20, G21) and the feed mode "
    "(G93, G94, G95) are those that are meant.",
    "G1 X1 F1000000000\nM2\n"};

inline constexpr ErrorPage kToleranceSwallows{
    1011,
    Severity::warning,
    "tolerance larger than the geometry",
    "G64 allows the path to leave the programmed one by its tolerance, and what is programmed here "
    "is smaller than that: a loop may vanish, a contour may lose its shape. Said once of each "
    "tolerance.",
    "Write a smaller P and Q, in the units in force (G20, G21), or G61 where the shape matters.",
    "G64 P1 F600\nG1 X10\nX10.1\nY0.1\nX10\nY0\nX20\nM2\n"};

inline constexpr std::array kMachinePages{
    &kOutsideTravel,     &kCurveRefused,    &kMachineWithoutLimit, &kTooLong,
    &kImpossibleSetting, &kFeedBeyondReach, &kToleranceSwallows};

}  // namespace kerf::errors
