// Pages of cutter radius compensation: G40, G41, G42, G41.1, G42.1.
#pragma once

#include <array>

#include "parser/errors/error_page.hpp"

namespace kerf::parser::errors {

inline constexpr ErrorPage kCompensationTwice{
    700,
    Severity::error,
    "compensation switched on twice",
    "G41 or G42 (also G41.1, G42.1) stands where cutter compensation is on already. Side and "
    "radius cannot change along a contour: the way from one to the other is not defined.",
    "Cancel with G40 on a move away from the contour first, then start again.",
    "G1 F100 X20\nG41.1 D5 X30\nG42.1 D5 X50\nM2\n"};

inline constexpr ErrorPage kCompensationPlane{
    701,
    Severity::error,
    "compensation in the YZ plane",
    "Cutter compensation works in the plane XY (G17) for mills and XZ (G18) for turning tools.",
    "Select G17 or G18 before G41 or G42.",
    "G19 G41.1 D5\nM2\n"};

inline constexpr ErrorPage kCompensationPlaneChange{
    702,
    Severity::error,
    "plane changed while compensation is on",
    "The offset contour lies in the plane in which compensation was started; in another plane the "
    "same moves have other corners.",
    "Cancel with G40, change the plane, and start again.",
    "G41.1 D5\nG1 F100 X20\nG18\nM2\n"};

inline constexpr ErrorPage kCompensationStartedOnArc{
    703,
    Severity::error,
    "compensation started on an arc",
    "The first move after G41 or G42 takes the tool from the programmed path to the point beside "
    "its end. That is a straight move: between a point on the path and one beside it there is no "
    "arc about the programmed centre.",
    "Put a straight lead-in (G0 or G1), longer than the tool radius, before the arc.",
    "G41.1 D5\nG2 F100 X20 I10\nM2\n"};

inline constexpr ErrorPage kCompensationEntryTooShort{
    704,
    Severity::error,
    "entry move not longer than the tool radius",
    "On the entry move the tool goes to one radius beside the contour. On a move that is not "
    "longer than the radius it would come from the side or from behind and cut the contour's "
    "start.",
    "Start farther away from the contour, or use a smaller tool.",
    "G41.1 D10\nG1 F100 X4\nX50\nG40 Y-20\nM2\n"};

inline constexpr ErrorPage kCompensationExitOnArc{
    705,
    Severity::error,
    "arc right after G40",
    "The first move after G40 takes the tool from beside the contour back to the programmed path, "
    "which an arc about the programmed centre cannot.",
    "Put a straight move between G40 and the arc.",
    "G41.1 D5\nG1 F100 X20\nX50\nG40\nG2 X70 I10\nM2\n"};

inline constexpr ErrorPage kCompensationArcTooSmall{
    706,
    Severity::error,
    "inside arc not larger than the tool",
    "The tool is on the inside of an arc whose radius is not greater than its own, so it would cut "
    "away the walls on both sides of the arc.",
    "Use a smaller tool, or program a larger radius.",
    "G41.1 D10\nG1 F100 X20\nX50\nG3 X54 Y4 J4\nG1 Y40\nG40 X0\nM2\n"};

inline constexpr ErrorPage kCompensationMoveTooShort{
    707,
    Severity::error,
    "move too short for its inside corners",
    "In an inside corner the tool stops short of the contour's corner, the more so the narrower it "
    "is. This move is shorter than what the corners at its ends take, so the tool cannot touch it "
    "without cutting into a neighbour.",
    "Use a smaller tool, or leave the small feature out of the contour. If the tool side is wrong, "
    "exchange G41 and G42.",
    "G41.1 D10\nG1 F100 X20\nX50\nY3\nX20\nG40 X0\nM2\n"};

inline constexpr ErrorPage kCompensationCornerTooTight{
    708,
    Severity::error,
    "inside corner too narrow for the tool",
    "Beside the two moves of this inside corner the paths of the tool's centre do not meet: "
    "wherever the tool touches one of them it cuts into the other.",
    "Use a smaller tool, or widen the corner. If the tool side is wrong, exchange G41 and G42.",
    "G41.1 D10\nG1 F100 X20\nX50\nG3 X38 I-6\nG1 Y-40\nG40 X0\nM2\n"};

inline constexpr ErrorPage kCompensationGouge{
    709,
    Severity::error,
    "tool cuts into another part of the contour",
    "The two moves are not neighbours, but the tool on its way past one of them comes nearer to "
    "the other than its radius, as in a slot that is narrower than the tool. The moves ahead are "
    "looked at before the tool moves.",
    "Use a smaller tool or widen the contour there. A roughing pass that is to be cut over needs a "
    "G40 between it and the next pass.",
    "G41.1 D10\nG1 F100 X20\nX60\nY40\nX70\nY50\nX52\nY8\nX30\nY20\nG40 X0 Y60\nM2\n"};

inline constexpr ErrorPage kCompensationEntryGouges{
    710,
    Severity::warning,
    "entry move cuts into the contour",
    "On its straight way to the contour the tool comes nearer to a later part of it than its "
    "radius.",
    "Enter from a place that is clear of the contour, or enter above the work and plunge "
    "afterwards.",
    "G41.1 D10\nG1 F100 X8\nX-30 Y10\nX-40 Y60\nG40 X-80\nM2\n"};

inline constexpr ErrorPage kCompensationExitGouges{
    711,
    Severity::warning,
    "exit move cuts into the contour",
    "The move behind G40 goes straight from beside the contour to its programmed end and comes "
    "nearer to the contour than the tool radius. A bare Z move behind G40 does so too: it takes "
    "the tool sideways onto the contour while it rises.",
    "Lead out away from the contour: write the G40 on a straight move off the part, and rise after "
    "it.",
    "G41.1 D10\nG1 F100 X20\nX50\nG40\nZ5\nM2\n"};

inline constexpr ErrorPage kCompensationLeftOn{
    712,
    Severity::warning,
    "compensation on at the end of the program",
    "The program ends between G41 or G42 and G40. The tool stays beside the contour, and the last "
    "move ends at a right angle to its end.",
    "End the contour with G40 and a straight move away from it.",
    "G41.1 D5\nG1 F100 X20\nX50\nM2\n"};

inline constexpr ErrorPage kNotWhileCompensating{
    713,
    Severity::error,
    "code not allowed while compensation is on",
    "The code changes where the program's coordinates lie, which tool is used, or goes to a place "
    "of the machine. The contour would jump in the middle, so it is refused, as LinuxCNC does.",
    "Cancel with G40 and a straight move first.",
    "G41.1 D5\nG1 F100 X20\nX50\nG53 G0 X0\nM2\n"};

inline constexpr ErrorPage kCurveWhileCompensating{
    714,
    Severity::error,
    "spline while compensation is on",
    "A spline's offset is not a spline, so cutter compensation works on lines and arcs only.",
    "Cancel with G40 first, or let the CAM system compute the tool's path.",
    "G41.1 D5\nG1 F100 X20\nX50\nG5.1 X60 Y10 I5 J5\nM2\n"};

inline constexpr ErrorPage kCycleWhileCompensating{
    715,
    Severity::error,
    "cycle or probing while compensation is on",
    "Drilling cycles and probing go to points, not along a contour. Beside the contour the hole "
    "would be in the wrong place.",
    "Cancel with G40 and a straight move first.",
    "G41.1 D5\nG1 F100 X20\nX50\nG81 X60 Z-5 R2\nG40 X70\nM2\n"};

inline constexpr ErrorPage kCompensationNegativeD{
    716,
    Severity::error,
    "negative D",
    "D of G41 and G42 is the number of a tool.",
    "Write D without the sign. To cut on the other side exchange G41 and G42.",
    "G41 D-1\nM2\n"};

inline constexpr ErrorPage kCompensationDNotWhole{
    717,
    Severity::error,
    "D is not whole",
    "D of G41 and G42 is the number of a tool; a diameter belongs to G41.1 and G42.1.",
    "Write the tool number in D, or G41.1 with the diameter.",
    "G41 D1.5\nM2\n"};

inline constexpr ErrorPage kCompensationWithoutD{
    718,
    Severity::error,
    "G41.1 or G42.1 without D",
    "G41.1 and G42.1 take the tool's diameter from D.",
    "Add D with the diameter, or use G41 and G42 with the tool table.",
    "G41.1\nM2\n"};

inline constexpr ErrorPage kCompensationUnknownTool{
    719,
    Severity::error,
    "D not in the tool table",
    "D names a tool that is not in the tool table, so its radius is not known.",
    "Correct D or add the tool to the table.",
    "G41 D100000\nM2\n"};

inline constexpr ErrorPage kCompensationOrientation{
    720,
    Severity::error,
    "L out of range",
    "L of G41.1 and G42.1 is the orientation of a turning tool's tip, 0 to 9.",
    "Write the orientation that the tool table would have.",
    "G18 G41.1 D5 L12\nM2\n"};

inline constexpr ErrorPage kCompensationOrientationPlane{
    721,
    Severity::error,
    "L outside the XZ plane",
    "L of G41.1 and G42.1 is the orientation of a turning tool's tip, which has a meaning only in "
    "the plane XZ (G18).",
    "Leave L out, or select G18.",
    "G41.1 D5 L2\nM2\n"};

inline constexpr ErrorPage kCompensationOtherSide{
    722,
    Severity::warning,
    "negative diameter",
    "A negative diameter puts the tool on the other side of the contour: G41.1 with a negative D "
    "is G42.1 with a positive one.",
    "If that is what is wanted write the other code; if not, take the sign out.",
    "G41.1 D-5\nG1 F100 X20\nX50\nG40 Y20\nM2\n"};

inline constexpr ErrorPage kCompensationHoldsTooMuch{
    723,
    Severity::error,
    "too many blocks between two moves of a contour",
    "The corner at the end of a move depends on the next move in the plane, so what stands between "
    "is held back. This program has more there than is held.",
    "Cancel with G40 before long sequences of dwells, events or moves along the plane's normal.",
    "G41.1 D5\nG1 F100 X20\nX50\n",
    Dialect::rs274,
    {"G4 P@\n", 1001}};

inline constexpr ErrorPage kCompensationWithoutRadius{
    724,
    Severity::warning,
    "compensation with a tool of no diameter",
    "The tool has the diameter 0 (no tool is loaded, or the table has none), so the path is run as "
    "programmed.",
    "Load the tool (T, M6), give D, or add the diameter to the tool table.",
    "G41\nG1 F100 X20\nX50\nG40 Y20\nM2\n"};

inline constexpr ErrorPage kCompensationTurned{
    725,
    Severity::error,
    "compensation in XZ under a turned coordinate system",
    "The coordinate system is turned about Z (G10 L2 R), so the program's plane XZ is none of the "
    "machine's.",
    "Set R to 0 for compensation in XZ.",
    "G10 L2 P1 R30\nG18 G41.1 D5\nM2\n"};

inline constexpr ErrorPage kCompensationSeam{
    726,
    Severity::warning,
    "closed contour begins in an inside corner",
    "The contour ends where it began, and that is an inside corner for the tool. The program has "
    "no move behind the last one that the tool could turn into, so the first and the last move run "
    "up to the corner and cut into each other by as much as the tool radius.",
    "Begin the contour in the middle of a straight move or at an outside corner.",
    "G0 X30 Y30\nG41.1 D10\nG1 F100 X10 Y10\nX60\nY60\nX10\nY10\nG40 X30 Y30\nM2\n"};

inline constexpr ErrorPage kCompensationScratch{
    727,
    Severity::warning,
    "tool cuts a hundredth into the contour",
    "The tool comes nearer to another part of the contour than its radius, but by no more than "
    "0.01 mm. Rounded coordinates do this where the tool fits an inside arc or a slot exactly.",
    "If that depth matters use a smaller tool, or more decimals in the program.",
    "G41.1 D10\nG1 F100 X20\nX60\nY40\nX70\nY50\nX52\nY9.995\nX30\nY20\nG40 X0 Y60\nM2\n"};

inline constexpr std::array kCompensationPages{
    &kCompensationTwice,        &kCompensationPlane,         &kCompensationPlaneChange,
    &kCompensationStartedOnArc, &kCompensationEntryTooShort, &kCompensationExitOnArc,
    &kCompensationArcTooSmall,  &kCompensationMoveTooShort,  &kCompensationCornerTooTight,
    &kCompensationGouge,        &kCompensationEntryGouges,   &kCompensationExitGouges,
    &kCompensationLeftOn,       &kNotWhileCompensating,      &kCurveWhileCompensating,

    &kCompensationNegativeD,    &kCompensationDNotWhole,     &kCompensationWithoutD,
    &kCompensationUnknownTool,  &kCompensationOrientation,   &kCompensationOrientationPlane,
    &kCompensationOtherSide,    &kCompensationHoldsTooMuch,  &kCompensationWithoutRadius,
    &kCompensationTurned,       &kCompensationSeam,          &kCompensationScratch};

}  // namespace kerf::parser::errors
