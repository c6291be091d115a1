// Pages of the splines G5 and G5.1 and of the B-spline G5.2 ... G5.3.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kSplineOutsideXy{
    350,
    Severity::error,
    "spline outside the XY plane",
    "G5 and G5.1 give their control points by I, J, P and Q, which lie in the XY plane.",
    "Write G17 before the spline.",
    "G18\nG5 X10 Y0 I0 J3 P0 Q-3 F100\nM2\n"};

inline constexpr ErrorPage kSplineWithZ{
    351,
    Severity::error,
    "Z in a planar spline",
    "G5 and G5.1 are curves in the XY plane; a Z word would have no effect on them.",
    "Take Z out, or move Z in a block of its own.",
    "G5 X10 Y0 Z5 I0 J3 P0 Q-3 F100\nM2\n"};

inline constexpr ErrorPage kSplineWithoutEnd{352,
                                             Severity::error,
                                             "spline without an end point",
                                             "G5 and G5.1 need the point where the curve ends.",
                                             "Give the block X, Y or both.",
                                             "G5 I0 J3 P0 Q-3 F100\nM2\n"};

inline constexpr ErrorPage kSplineInverseTime{
    353,
    Severity::error,
    "curve with inverse time feed",
    "With G93 a block says how long it takes, but the length of this curve is known only when all "
    "of it was read.",
    "Write G94 and a feed per minute before the curve.",
    "G93\nG5 X10 Y0 I0 J3 P0 Q-3 F1\nM2\n"};

inline constexpr ErrorPage kHighSpeedMode{
    354,
    Severity::warning,
    "high-speed mode is ignored",
    "G05 P10000, G05 P0 and G05.1 Q1 switch the look-ahead of a Fanuc control. Kerf always looks "
    "ahead, so they change nothing here.",
    "Nothing needs to be done; take the block out to be rid of the warning.",
    "G5.1 Q1\nM2\n"};

inline constexpr ErrorPage kSplineWithoutHandle{
    355,
    Severity::error,
    "G5 without P and Q",
    "P and Q say how the curve arrives at its end point: the second control point as seen from "
    "there.",
    "Give the block P and Q.",
    "G5 X10 Y0 I0 J3 F100\nM2\n"};

inline constexpr ErrorPage kHalfSplineStart{
    356,
    Severity::error,
    "only one of I and J",
    "I and J say together how the curve leaves its start. Both may be left out, then the curve "
    "goes on smoothly from the G5 before it.",
    "Give both I and J (0 where there is none), or neither.",
    "G5 X10 Y0 I3 P0 Q-3 F100\nM2\n"};

inline constexpr ErrorPage kFirstSplineWithoutStart{
    357,
    Severity::error,
    "first spline without I and J",
    "I and J may be left out only straight behind another G5, whose direction the curve then takes "
    "on.",
    "Give the first G5 of the series I and J.",
    "G5 X10 Y0 P0 Q-3 F100\nM2\n"};

inline constexpr ErrorPage kSplineUnusedQ{
    358,
    Severity::error,
    "Q in a quadratic spline",
    "G5.1 has one control point, given by I and J. Q belongs to G5, or without axis words to "
    "Fanuc's high-speed mode.",
    "Take Q out, or write G5 where a cubic spline is meant.",
    "G5.1 X10 Y0 I5 J5 Q1 F100\nM2\n"};

inline constexpr ErrorPage kQuadraticWithoutHandle{
    359,
    Severity::error,
    "G5.1 without I and J",
    "I and J give the control point of the quadratic spline as seen from its start.",
    "Give the block I, J or both.",
    "G5.1 X10 Y0 F100\nM2\n"};

inline constexpr ErrorPage kOpenWithoutCurve{
    360,
    Severity::error,
    "G5.3 without G5.2",
    "G5.3 ends a B-spline that G5.2 began, and none is open.",
    "Take the block out, or look for the G5.2 that is missing before it.",
    "G5.3\nM2\n"};

inline constexpr std::array kSplinesPages{&kSplineOutsideXy,  &kSplineWithZ,
                                          &kSplineWithoutEnd, &kSplineInverseTime,
                                          &kHighSpeedMode,    &kSplineWithoutHandle,
                                          &kHalfSplineStart,  &kFirstSplineWithoutStart,
                                          &kSplineUnusedQ,    &kQuadraticWithoutHandle,
                                          &kOpenWithoutCurve};

}  // namespace kerf::errors
