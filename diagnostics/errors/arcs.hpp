// Pages of arcs, G2 and G3.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kArcStillActive{
    220,
    Severity::error,
    "an arc is still active",
    "G2 and G3 stay in force until another motion code comes. This block gives coordinates only, "
    "so it is one more arc, and lacks its centre.",
    "Write G1 in the block where a straight line is meant, or give the arc its centre or radius.",
    "G2 X10 Y0 I5 F100\nX20\nM2\n"};

inline constexpr ErrorPage kArcWithoutCentre{
    221,
    Severity::error,
    "arc without centre and radius",
    "An arc needs its end point and either its centre (I, J, K: those of the plane's two axes) or "
    "its radius (R).",
    "Give the block the centre or R, and see that the plane (G17, G18, G19) is the one meant.",
    "G2 X10 Y0 F100\nM2\n"};

inline constexpr ErrorPage kTurnsNotWhole{
    222,
    Severity::error,
    "turns of an arc with decimals",
    "P of an arc says how many turns a helix makes, counted from 1.",
    "Write P as a whole number, or leave it out for a single turn.",
    "G2 X0 Y0 Z-5 I5 P1.5 F100\nM2\n"};

inline constexpr ErrorPage kTurnsOutOfRange{
    223,
    Severity::error,
    "turns of an arc out of range",
    "P of an arc says how many turns a helix makes, counted from 1, up to a million.",
    "Write P as 1 or more, or leave it out for a single turn.",
    "G2 X0 Y0 Z-5 I5 P0 F100\nM2\n"};

inline constexpr ErrorPage kZeroRadius{224,
                                       Severity::error,
                                       "radius 0",
                                       "R0 is no arc.",
                                       "Write the radius, or G1 where a straight line is meant.",
                                       "G2 X10 Y0 R0 F100\nM2\n"};

inline constexpr ErrorPage kRadiusWithoutEnd{
    225,
    Severity::error,
    "radius without an end point",
    "An arc by radius is found from its start, its end and R; without an end point in the plane "
    "there is no arc.",
    "Give the end point; a full circle is written with its centre (I, J, K).",
    "G2 R5 F100\nM2\n"};

inline constexpr ErrorPage kRadiusFullCircle{
    226,
    Severity::error,
    "full circle by radius",
    "The end point is the start point. Any number of circles with this radius goes through one "
    "point, so R cannot say which is meant.",
    "Write the full circle with its centre (I, J, K), or as two halves.",
    "G2 X0 Y0 R5 F100\nM2\n"};

inline constexpr ErrorPage kRadiusTooSmall{
    227,
    Severity::error,
    "radius too small",
    "No circle of this radius reaches from the start to the end: it must be at least half of the "
    "distance between them.",
    "Correct R or the end point. See whether the move before ended where the arc should start, and "
    "whether X is meant as a diameter.",
    "G2 X20 Y0 R5 F100\nM2\n"};

inline constexpr ErrorPage kCentreIsStart{
    228,
    Severity::error,
    "centre is the start point",
    "The centre given is the point where the arc starts, so its radius is 0.",
    "Correct I, J, K: with G91.1 they count from the start point, with G90.1 from the origin.",
    "G2 X10 Y0 I0 J0 F100\nM2\n"};

inline constexpr ErrorPage kRadiiDiffer{
    229,
    Severity::error,
    "radius differs between start and end",
    "Start and end of an arc must be equally far from its centre. A difference of up to 0.0283 mm "
    "passes as rounding, or of 0.1 % of the radius up to 2.83 mm; this one is larger, so the words "
    "do not describe a circle.",
    "Have the post-processor write more decimals, or correct the centre. Where it is meant as a "
    "position write G90.1, where it counts from the start point G91.1.",
    "G2 X10 Y0 I6 F100\nM2\n"};

inline constexpr ErrorPage kAbsoluteCentreIncomplete{
    230,
    Severity::error,
    "absolute centre with one coordinate",
    "With G90.1 the centre is a position, and each position in a plane has two coordinates. One "
    "left out is not taken as 0.",
    "Give both centre words, or write G91.1 where they count from the start point.",
    "G90.1\nG2 X10 Y0 I5 F100\nM2\n"};

inline constexpr ErrorPage kCentreOutsidePlane{
    231,
    Severity::error,
    "centre word of another plane",
    "An arc lies in the active plane: G17 has I and J, G18 has I and K, G19 has J and K. The word "
    "belongs to none of the two.",
    "Choose the plane that is meant before the arc, or correct the word.",
    "G2 X10 Y0 I5 K1 F100\nM2\n"};

inline constexpr ErrorPage kRadiusAndCentre{
    232,
    Severity::error,
    "radius and centre both given",
    "R and the centre words each describe the whole arc, and the two may disagree.",
    "Take R out, or the centre words.",
    "G2 X10 Y0 I5 R5 F100\nM2\n"};

inline constexpr std::array kArcsPages{&kArcStillActive,
                                       &kArcWithoutCentre,
                                       &kTurnsNotWhole,
                                       &kTurnsOutOfRange,
                                       &kZeroRadius,
                                       &kRadiusWithoutEnd,
                                       &kRadiusFullCircle,
                                       &kRadiusTooSmall,
                                       &kCentreIsStart,
                                       &kRadiiDiffer,
                                       &kAbsoluteCentreIncomplete,
                                       &kCentreOutsidePlane,
                                       &kRadiusAndCentre};

}  // namespace kerf::errors
