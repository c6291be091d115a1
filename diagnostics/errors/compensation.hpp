// Pages of cutter radius compensation: G40, G41, G42, G41.1, G42.1.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

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
    "",
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

inline constexpr ErrorPage kCompensationSideChange{
    748,
    Severity::error,
    "side changed without G40",
    "On a Fanuc control G42 while G41 is active takes the tool to the other side of the contour, "
    "on "
    "a way that parameters of the control decide. Kerf does not follow it.",
    "Write G40 with a move away from the contour, then G42 with a move back to it.",
    "G41 D1 G1 X20. F100\nG42 X40.\nG40 X60. Y20.\nM30\n",
    "fanuc"};

inline constexpr std::array kCompensationPages{&kCompensationSideChange,
                                               &kCompensationTwice,
                                               &kCompensationPlane,
                                               &kCompensationPlaneChange,
                                               &kCompensationStartedOnArc,
                                               &kCompensationEntryTooShort,
                                               &kCompensationExitOnArc,
                                               &kCompensationLeftOn,
                                               &kNotWhileCompensating,
                                               &kCurveWhileCompensating,
                                               &kCycleWhileCompensating,
                                               &kCompensationNegativeD,
                                               &kCompensationDNotWhole,
                                               &kCompensationWithoutD,
                                               &kCompensationUnknownTool,
                                               &kCompensationOrientation,
                                               &kCompensationOrientationPlane,
                                               &kCompensationOtherSide,
                                               &kCompensationHoldsTooMuch,
                                               &kCompensationWithoutRadius,
                                               &kCompensationTurned};

}  // namespace kerf::errors
