// Pages of the G and M codes themselves.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kUnknownGCode{
    100,
    Severity::error,
    "unknown G code",
    "The block has a G code that no version of this language gives a meaning. Nothing in the block "
    "is run, since the code might have changed what its other words mean.",
    "Correct the code. A typing error (G41 for G4 1) and a post-processor for another control are "
    "the usual causes.",
    "G1 X10 F100\nG123\nM2\n"};

inline constexpr ErrorPage kUnknownMCode{
    101,
    Severity::error,
    "unknown M code",
    "The block has an M code that has no meaning here. On many controls such codes are wired by "
    "the builder of the machine, so a program from elsewhere may hold codes of that machine.",
    "Take the code out, or put in the one that does the same on this machine.",
    "G1 X10 F100\nM77\nM2\n"};

inline constexpr ErrorPage kDecimalMCode{102,
                                         Severity::error,
                                         "M code with a decimal part",
                                         "M codes are whole numbers; only some G codes have a "
                                         "decimal part (G5.1, G59.3).",
                                         "Write the M code without its decimals.",
                                         "M3.5 S1000\nM2\n"};

inline constexpr ErrorPage kCodeNotSupported{
    103,
    Severity::error,
    "code not supported",
    "The code is a known one but Kerf does not run it. It is refused and not passed over: the "
    "blocks behind it count on its effect.",
    "Write the program without the code; most post-processors have a switch for it.",
    "G15\nM2\n"};

inline constexpr ErrorPage kPrinterCode{
    104,
    Severity::error,
    "code of a 3D printer",
    "The M code is one of those that set temperatures, fans and extruders. The file was most "
    "likely made by a slicer for a 3D printer.",
    "Load a program that was made for a milling machine.",
    "M104 S200\nM2\n"};

inline constexpr ErrorPage kSameModalGroup{
    105,
    Severity::error,
    "two codes of one modal group",
    "Codes of one modal group exclude each other: only one motion, one plane, one unit can hold "
    "in a block. Which of the two was meant cannot be told.",
    "Take one of the two codes out, or give each a block of its own.",
    "G1 G2 X10 Y0 I5 F100\nM2\n"};

inline constexpr ErrorPage kLatheCode{
    106,
    Severity::error,
    "code of a lathe",
    "G7 and G8 say whether X is a diameter or a radius. On a mill it is neither: X is a place.",
    "Take the code out; a program for a lathe cannot be run on a mill.",
    "G7\nM2\n"};

inline constexpr ErrorPage kFanucCode{
    107,
    Severity::error,
    "code of the Fanuc dialect",
    "G44, G50, G51, G54.1, G68 and G69 place, scale and turn a program on Fanuc controls. "
    "RS274/NGC, "
    "the "
    "language that this program is read in, does not have them.",
    "Read the program as one for Fanuc (--dialect fanuc), or do without the code: G10 L2 R turns a "
    "work offset.",
    "G68 X0 Y0 R45\nM2\n"};

inline constexpr std::array kCodesPages{&kUnknownGCode,     &kUnknownMCode, &kDecimalMCode,
                                        &kCodeNotSupported, &kPrinterCode,  &kSameModalGroup,
                                        &kLatheCode,        &kFanucCode};

}  // namespace kerf::errors
