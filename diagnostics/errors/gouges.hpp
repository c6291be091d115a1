// Pages of cutter radius compensation where the tool does not fit the contour.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

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

inline constexpr std::array kGougesPages{&kCompensationArcTooSmall,    &kCompensationMoveTooShort,
                                         &kCompensationCornerTooTight, &kCompensationGouge,
                                         &kCompensationEntryGouges,    &kCompensationExitGouges,
                                         &kCompensationSeam,           &kCompensationScratch};

}  // namespace kerf::errors
