// Pages that hold for every curve with control points: G5, G5.1, G5.2 and G6.2.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kCurveInverseTime{
    300,
    Severity::error,
    "NURBS with inverse time feed",
    "With G93 a block says how long it takes, but a NURBS reaches over many blocks.",
    "Write G94 and a feed per minute before the curve.",
    "G93\nG6.2 P3 K0 X0 Y0 F1\nM2\n"};

inline constexpr ErrorPage kCurveIsAPoint{
    301,
    Severity::warning,
    "curve of no length",
    "All control points of the curve are one point, so there is nothing to move. The curve is left "
    "out.",
    "Take the curve out, or correct its points.",
    "G5 X0 Y0 I0 J0 P0 Q0 F100\nM2\n"};

inline constexpr ErrorPage kWeightsFarApart{
    302,
    Severity::warning,
    "weights far apart",
    "The greatest weight is more than a million times the smallest. The curve then all but misses "
    "the points of low weight and turns very sharply at others.",
    "See whether the weights were scaled as they should be.",
    "G5.2 P1 X0 Y0 L3 F100\nX10 Y0 P1\nX10 Y10 P10000000\nX0 Y10 P1\nG5.3\nM2\n"};

inline constexpr ErrorPage kCurveForeignAxis{
    303,
    Severity::error,
    "axis outside the curve's plane",
    "The curve lies in the active plane (G17, G18, G19), and this axis is not one of the plane's "
    "two.",
    "Take the word out, or choose the plane that is meant before the curve.",
    "G5.2 P1 X0 Y5 L3 F100\nX10 Y0 Z5\nG5.3\nM2\n"};

inline constexpr ErrorPage kCurveOneAxis{
    304,
    Severity::error,
    "control point with one coordinate",
    "A control point in a plane has two coordinates. One left out is not taken over from the point "
    "before.",
    "Give both coordinates of the control point.",
    "G5.2 P1 X0 Y5 L3 F100\nX10\nG5.3\nM2\n"};

inline constexpr std::array kCurvesPages{&kCurveInverseTime, &kCurveIsAPoint, &kWeightsFarApart,
                                         &kCurveForeignAxis, &kCurveOneAxis};

}  // namespace kerf::errors
