// Pages of the B-spline G5.2 ... G5.3, whose knots are made by the control.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kSplineWeight{
    370,
    Severity::error,
    "weight not greater than 0",
    "P is the weight of a control point: how strongly it draws the curve. With a weight of 0 or "
    "below the curve is not defined everywhere.",
    "Write P greater than 0; 1 where there is no reason for another value.",
    "G5.2 P0 X1 Y5 L3 F100\nX10 Y0\nG5.3\nM2\n"};

inline constexpr ErrorPage kSplineOrder{
    371,
    Severity::error,
    "order out of range",
    "L is the order of the B-spline, its degree plus 1: a whole number from 3 to 10.",
    "Write an order from 3 to 10, or leave L out for 3.",
    "G5.2 P1 X1 Y5 L2 F100\nX10 Y0\nG5.3\nM2\n"};

inline constexpr ErrorPage kForeignInSpline{
    372,
    Severity::error,
    "word or code inside a B-spline",
    "Between G5.2 and G5.3 a block holds a control point (axis words and P) and nothing else. G5.3 "
    "may also be missing before this block.",
    "Move the block before G5.2 or behind G5.3, or write the G5.3 that is missing.",
    "G5.2 P1 X0 Y5 L3 F100\nM8\nX10 Y0\nG5.3\nM2\n"};

inline constexpr ErrorPage kOrderNotFirst{
    373,
    Severity::error,
    "order behind the first block",
    "L is the order of the whole B-spline and can be given only in the block of G5.2.",
    "Move L to the first block.",
    "G5.2 P1 X0 Y5 L3 F100\nX10 Y0 L3\nG5.3\nM2\n"};

inline constexpr ErrorPage kSplineTooManyPoints{
    374,
    Severity::error,
    "too many control points",
    "A curve is read and planned as a whole, which takes some 4 kB of memory for each control "
    "point, so it may have 20000 of them.",
    "Cut the curve into several.",
    "G5.2 P1 X0 Y5 L3 F100\n",
    "",
    {"X1 Y1\n", 20'000}};

inline constexpr ErrorPage kForeignInSplineEnd{
    375,
    Severity::error,
    "words in the block of G5.3",
    "G5.3 ends the curve at the last control point; it takes no words.",
    "Give the words a block of their own before or behind.",
    "G5.2 P1 X0 Y5 L3 F100\nX10 Y0\nG5.3 X20\nM2\n"};

inline constexpr ErrorPage kSplineFewPoints{
    376,
    Severity::error,
    "too few control points",
    "A B-spline of order L needs at least L control points, of which the start point is the first.",
    "Give more control points, or a lower order.",
    "G5.2 P1 X0 Y5 L4 F100\nX10 Y0\nG5.3\nM2\n"};

inline constexpr ErrorPage kSplineWeightAlone{
    377,
    Severity::error,
    "weight without a control point",
    "P is the weight of the control point of its block, and this block has no point.",
    "Give the block X and Y, or take P out.",
    "G5.2 P1 X0 Y5 L3 F100\nP2\nX10 Y0\nG5.3\nM2\n"};

inline constexpr ErrorPage kSplineUnfinished{
    378,
    Severity::error,
    "B-spline not closed",
    "The curve begun by G5.2 is still open where the program ends. Nothing of it is run.",
    "Write G5.3 behind the last control point.",
    "G5.2 P1 X0 Y5 L3 F100\nX10 Y0\nM2\n"};

inline constexpr std::array kBsplinesPages{
    &kSplineWeight,    &kSplineOrder,         &kForeignInSpline,
    &kOrderNotFirst,   &kSplineTooManyPoints, &kForeignInSplineEnd,
    &kSplineFewPoints, &kSplineWeightAlone,   &kSplineUnfinished};

}  // namespace kerf::errors
