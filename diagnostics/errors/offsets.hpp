// Pages of coordinates, offsets and the tool table.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kTwoAxisUsers{
    600,
    Severity::error,
    "two codes that use the axis words",
    "The block has a motion code beside G10, G28, G30, G52, G92, G43.1 or G43.2, and both take the "
    "axis words. To which of the two they belong cannot be told. Only G0 beside G28 or G30 is "
    "clear, and is run.",
    "Give each of the two codes a block of its own.",
    "G28 G1 X5 F100\nM2\n"};

inline constexpr ErrorPage kAxisWordMissing{
    601,
    Severity::error,
    "axis word missing",
    "G52, G92, G43.1 and G43.2 without H set something for each axis that has a word in their "
    "block, and there is no such word.",
    "Name the axes: G92 X0 Y0.",
    "G92\nM2\n"};

inline constexpr ErrorPage kNegativeOffsetNumber{
    602,
    Severity::error,
    "negative offset number",
    "H and D are numbers of tools in the tool table and count from 0.",
    "Write the number of a tool.",
    "G43 H-5\nM2\n"};

inline constexpr ErrorPage kOffsetNumberNotWhole{
    603,
    Severity::error,
    "offset number with decimals",
    "H and D are numbers of tools in the tool table, which are whole.",
    "Write the number of a tool without decimals.",
    "G43 H1.5\nM2\n"};

inline constexpr ErrorPage kToolNotInTable{
    604,
    Severity::error,
    "tool that is not in the tool table",
    "The machine has a tool table and the tool with this number (from T, H, D, M61 Q or G10 P) is "
    "not in it, so its length and diameter are not known.",
    "Correct the number, or enter the tool in the tool table that the machine file names.",
    "T99 M6\nM2\n"};

inline constexpr ErrorPage kIdleOffsetNumber{
    605,
    Severity::warning,
    "H or D that nothing uses",
    "H names the tool length for G43 and D the tool radius for G41 or G42; neither of them is in "
    "this block, so the word has no effect. Some controls keep such a number for later.",
    "Write H in the block of G43 and D in the block of G41 or G42, or take the word out.",
    "D4\nM2\n"};

inline constexpr ErrorPage kG10WithoutKind{
    606,
    Severity::error,
    "G10 without L",
    "L says what G10 writes: L2 and L20 a work offset, L1, L10 and L11 the offsets of a tool.",
    "Write L.",
    "G10 P1 X0\nM2\n"};

inline constexpr ErrorPage kG10UnknownKind{
    607,
    Severity::error,
    "unknown kind of G10",
    "L1 writes a tool, L10 and L11 a tool from the present position, L2 a work offset, L20 a work "
    "offset from the present position. There are no others.",
    "Correct L.",
    "G10 L7 P1 X0\nM2\n"};

inline constexpr ErrorPage kG10Number{
    608,
    Severity::error,
    "G10 with a wrong P",
    "P says which work offset (1 to 9 for G54 to G59.3, 0 for the one in force) or which tool G10 "
    "writes.",
    "Write P as a whole number in the range that the message names.",
    "G10 L2 P99 X0\nM2\n"};

inline constexpr ErrorPage kG10UnusedWord{
    609,
    Severity::error,
    "word that this kind of G10 does not use",
    "R turns a work offset (L2) or is a tool radius (L1, L10, L11); I, J and Q describe turning "
    "tools (L1, L10, L11).",
    "Take the word out, or use the kind of G10 that takes it.",
    "G10 L20 P1 X0 R30\nM2\n"};

inline constexpr ErrorPage kToolOrientation{
    610,
    Severity::error,
    "tool orientation out of range",
    "Q of G10 is the orientation of a turning tool, a whole number from 0 to 9.",
    "Correct Q.",
    "G10 L1 P1 Z1 Q12\nM2\n"};

inline constexpr ErrorPage kTurnedArcPlane{
    611,
    Severity::error,
    "arc across a turned work offset",
    "The work offset in force is turned about Z (G10 L2 R). An arc of the XZ or YZ plane would "
    "then lie in a plane that is none of the machine's.",
    "Use arcs of the XY plane, or a work offset without R.",
    "G10 L2 P1 R30\nG18 G2 X10 I5 F100\nM2\n"};

inline constexpr std::array kOffsetsPages{
    &kTwoAxisUsers,   &kAxisWordMissing,  &kNegativeOffsetNumber, &kOffsetNumberNotWhole,
    &kToolNotInTable, &kIdleOffsetNumber, &kG10WithoutKind,       &kG10UnknownKind,
    &kG10Number,      &kG10UnusedWord,    &kToolOrientation,      &kTurnedArcPlane};

}  // namespace kerf::errors
