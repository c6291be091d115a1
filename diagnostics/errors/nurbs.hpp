// Pages of G6.2, NURBS with their knots in the text.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kNurbsOrder{
    310,
    Severity::error,
    "order out of range",
    "P is the order of the NURBS, its degree plus 1: a whole number from 2 to 10.",
    "Write an order from 2 to 10, or leave P out for 4.",
    "G6.2 P1 K0 X0 Y0 F100\nM2\n"};

inline constexpr ErrorPage kNurbsForm{
    311,
    Severity::error,
    "Q is not 1, 2 or 3",
    "Q in the first block chooses LinuxCNC's form of G6.2, in the active plane; its values are 1, "
    "2 and 3.",
    "Write one of the three, or leave Q out for Fanuc's form.",
    "G6.2 P3 Q4 K0 X0 Y0 F100\nM2\n"};

inline constexpr ErrorPage kPointMissing{
    312,
    Severity::error,
    "control point missing in the first block",
    "The first block of a NURBS gives the order P, the first knot K and the first control point, "
    "which is where the tool stands.",
    "Give the block the control point it starts from. Where the curve before was complete, see "
    "whether it has too many knot-only blocks.",
    "G6.2 K0 F100\nM2\n"};

inline constexpr ErrorPage kKnotMissing{
    313,
    Severity::error,
    "control point without a knot",
    "Each control point of a NURBS comes with its knot, K.",
    "Give the block K; where a straight line is meant, write G1: G6.2 is still active.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nX5 Y5\nM2\n"};

inline constexpr ErrorPage kFirstPoint{
    314,
    Severity::error,
    "first control point is not the current position",
    "A NURBS starts at its first control point, so the tool must stand there already.",
    "Move the tool to the first control point before G6.2.",
    "G0 X1 Y0\nG6.2 P3 K0 X0 Y0 F100\nM2\n"};

inline constexpr ErrorPage kNurbsWeight{
    315,
    Severity::error,
    "weight not greater than 0",
    "R is the weight of a control point: how strongly it draws the curve. With a weight of 0 or "
    "below the curve is not defined everywhere.",
    "Write R greater than 0; 1 where there is no reason for another value.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5 R0\nM2\n"};

inline constexpr ErrorPage kNurbsWeightAlone{
    316,
    Severity::error,
    "weight without a control point",
    "R is the weight of the control point of its block, and this block has no point.",
    "Give the block its axis words, or take R out.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nR2\nM2\n"};

inline constexpr ErrorPage kPointAfterTail{
    317,
    Severity::error,
    "control point after the knot-only blocks",
    "A NURBS ends with P blocks that have only a knot. One or more of them were read, and then a "
    "control point came.",
    "See whether the block before lacks its coordinates, or whether knot-only blocks are missing.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5\nK0 X10 Y0\nK1\nK1 X15 Y5\nM2\n"};

inline constexpr ErrorPage kNurbsTooManyPoints{
    318,
    Severity::error,
    "too many control points",
    "A curve is read and planned as a whole, which takes some 4 kB of memory for each control "
    "point, so it may have 20000 of them.",
    "Cut the curve into several.",
    "G6.2 P3 K0 X0 Y0 F100\nK0 X1 Y1\nK0 X1 Y1\n",
    "",
    {"K@ X1 Y1\n", 20'000}};

inline constexpr ErrorPage kNurbsNewAxis{
    319,
    Severity::error,
    "axis that the first control point lacks",
    "All control points of a NURBS have the axes of its first one.",
    "Give the first control point all axes that the curve moves.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5 Z1\nM2\n"};

inline constexpr ErrorPage kForeignInNurbs{
    320,
    Severity::error,
    "word or code inside a NURBS",
    "Until a NURBS is complete its blocks hold control points (axis words, K and R) and knots, and "
    "nothing else.",
    "Move the block before the curve or behind it. See whether knot-only blocks are missing at the "
    "end of the curve.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nM8\nM2\n"};

inline constexpr ErrorPage kFirstBlockOnly{
    321,
    Severity::error,
    "order behind the first block",
    "P and Q hold for the whole NURBS and can be given only in its first block.",
    "Move the word to the first block. See whether the curve before lacks knot-only blocks at its "
    "end.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5 P3\nM2\n"};

inline constexpr ErrorPage kKnotDecreases{
    322,
    Severity::error,
    "knots go down",
    "Each knot must be as large as the one before it or larger.",
    "Correct the knot; a typing error or a block that was lost is the usual cause.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5\nK0 X10 Y0\nK-1\nM2\n"};

inline constexpr ErrorPage kHeadKnots{
    323,
    Severity::error,
    "first knots are not equal",
    "The curve starts at its first control point, so its first P knots must be equal (P is the "
    "order).",
    "Correct the knots or the order. Some CAM systems leave out the first and the last knot: have "
    "them written.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK1 X5 Y5\nM2\n"};

inline constexpr ErrorPage kTailKnots{
    324,
    Severity::error,
    "last knots are not equal",
    "The curve ends at its last control point, so its last P knots must be equal (P is the order).",
    "Correct the knots or the order. Some CAM systems leave out the first and the last knot: have "
    "them written.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5\nK0 X10 Y0\nK1\nK2\nM2\n"};

inline constexpr ErrorPage kKnotTooOften{
    325,
    Severity::error,
    "knot repeated too often",
    "A knot inside the curve may be there at most P - 1 times (P is the order), at an end P times. "
    "More of them would tear the curve apart.",
    "Take the knots out that are too many; see whether P is the degree instead of the order.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5\nK0 X10 Y0\nK0 X15 Y5\nM2\n"};

inline constexpr ErrorPage kNurbsFewPoints{
    326,
    Severity::error,
    "too few control points",
    "A NURBS of order P needs at least P control points, the first block's among them.",
    "Give more control points, or a lower order.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5\nK0\nM2\n"};

inline constexpr ErrorPage kNoParameterRange{
    327,
    Severity::error,
    "all knots are equal",
    "The curve runs over its knots from the first to the last, and these are equal.",
    "Correct the knots.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5\nK0 X10 Y0\nK0\nK0\nK0\nM2\n"};

inline constexpr ErrorPage kNurbsUnfinished{
    328,
    Severity::error,
    "NURBS not complete",
    "A NURBS ends with P blocks that have only a knot (P is the order), and they are not all "
    "there. Nothing of the curve is run.",
    "Write the knot-only blocks that are missing.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5\nK0 X10 Y0\nK1\nM2\n"};

inline constexpr ErrorPage kImplicitNurbs{
    329,
    Severity::warning,
    "new NURBS without G6.2",
    "The curve before is complete and G6.2 is still active, so this block begins another curve, of "
    "order 4.",
    "Write G6.2 with P in the block.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5\nK0 X10 Y0\nK1\nK1\nK1\nK0 X10 Y0\nK0 X15 Y0\nK0 "
    "X20 Y0\nK0 X25 Y0\nK1\nK1\nK1\nK1\nM2\n"};

inline constexpr ErrorPage kFeedInNurbs{
    330,
    Severity::warning,
    "feed inside a NURBS",
    "A NURBS runs at the feed of its first block. This F is taken over when the curve is complete.",
    "Write F in the first block of the curve, or behind the curve.",
    "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F100\nK0 X5 Y5 F200\nK0 X10 Y0\nK1\nK1\nK1\nM2\n"};

inline constexpr std::array kNurbsPages{
    &kNurbsOrder,     &kNurbsForm,        &kPointMissing,     &kKnotMissing,        &kFirstPoint,
    &kNurbsWeight,    &kNurbsWeightAlone, &kPointAfterTail,   &kNurbsTooManyPoints, &kNurbsNewAxis,
    &kForeignInNurbs, &kFirstBlockOnly,   &kKnotDecreases,    &kHeadKnots,          &kTailKnots,
    &kKnotTooOften,   &kNurbsFewPoints,   &kNoParameterRange, &kNurbsUnfinished,    &kImplicitNurbs,
    &kFeedInNurbs};

}  // namespace kerf::errors
