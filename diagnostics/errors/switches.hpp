// Pages of the spindle, the tool change, inputs and outputs, overrides and saved modes.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kSurfaceSpeedWithoutS{
    650,
    Severity::error,
    "surface speed without S",
    "G96 keeps the surface speed S (m/min or feet/min), and S is not in its block. The S before it "
    "was in revolutions per minute.",
    "Write S with the surface speed in the block of G96.",
    "G96\nM2\n"};

inline constexpr ErrorPage kNegativeMostSpeed{
    651,
    Severity::error,
    "negative highest speed",
    "D of G96 is the highest spindle speed in revolutions per minute.",
    "Write D without the sign.",
    "G96 S100 D-1\nM2\n"};

inline constexpr ErrorPage kOrientWay{652,
                                      Severity::error,
                                      "unknown way to orient the spindle",
                                      "P of M19 says which way the spindle turns to its angle: 0 "
                                      "the shorter way, 1 clockwise, 2 counterclockwise.",
                                      "Correct P.",
                                      "M19 R0 P3\nM2\n"};

inline constexpr ErrorPage kOrientTime{
    653,
    Severity::error,
    "no time to orient the spindle",
    "Q of M19 is how many seconds the spindle may take at the most.",
    "Write Q greater than 0, or leave it out.",
    "M19 R0 Q0\nM2\n"};

inline constexpr ErrorPage kNoSpeedForFeed{654,
                                           Severity::error,
                                           "feed per revolution without a spindle speed",
                                           "With G95 the feed is F times the speed of the spindle, "
                                           "and the speed is 0: the tool would never arrive.",
                                           "Write S, and start the spindle with M3 or M4.",
                                           "G95 F0.1 G1 X10\nM2\n"};

inline constexpr ErrorPage kFeedOfStoppedSpindle{
    655,
    Severity::warning,
    "feed per revolution with the spindle stopped",
    "With G95 the tool moves as the spindle turns, and the spindle is stopped. A machine with an "
    "encoder on its spindle would wait for ever; here the feed is that of the programmed speed S.",
    "Start the spindle with M3 or M4, or go back to G94.",
    "S1000 G95 F0.1 G1 X10\nM2\n"};

inline constexpr ErrorPage kToolNumberMissing{
    656,
    Severity::error,
    "M61 without a tool number",
    "M61 says which tool is in the spindle; Q is its number.",
    "Write Q with the number of the tool.",
    "M61\nM2\n"};

inline constexpr ErrorPage kSwitchValue{657,
                                        Severity::error,
                                        "switch that is neither on nor off",
                                        "P of M50 to M53 is 1 for on or 0 for off.",
                                        "Write P0 or P1.",
                                        "M50 P2\nM2\n"};

inline constexpr ErrorPage kChannelMissing{
    658,
    Severity::error,
    "output without its number",
    "M62 to M65 need P, the number of a digital output; M67 and M68 need E, that of an analog one.",
    "Write the number of the output.",
    "M64\nM2\n"};

inline constexpr ErrorPage kChannelOutOfRange{
    659,
    Severity::error,
    "no such input or output",
    "The machine does not have an input or output with this number.",
    "Write a whole number in the range that the message names.",
    "M64 P64\nM2\n"};

inline constexpr ErrorPage kOutputValueMissing{
    660,
    Severity::error,
    "analog output without a value",
    "Q of M67 and M68 is the value that the output gets.",
    "Write Q.",
    "M68 E0\nM2\n"};

inline constexpr ErrorPage kInputMissing{
    661,
    Severity::error,
    "M66 without its input",
    "M66 waits for one input: P is the number of a digital one, E that of an analog one.",
    "Write P or E, and only one of them.",
    "M66 L0\nM2\n"};

inline constexpr ErrorPage kWaitKind{662,
                                     Severity::error,
                                     "unknown way to wait for an input",
                                     "L of M66 says what it waits for: 0 nothing, 1 a rise, 2 a "
                                     "fall, 3 high, 4 low. An analog input can only be read (0).",
                                     "Correct L.",
                                     "M66 P0 L5 Q1\nM2\n"};

inline constexpr ErrorPage kWaitTime{663,
                                     Severity::error,
                                     "wait for an input without a time",
                                     "Q of M66 is how many seconds it waits at the most. It must "
                                     "be greater than 0 where there is something to wait for.",
                                     "Write Q greater than 0.",
                                     "M66 P0 L3\nM2\n"};

inline constexpr ErrorPage kNoSavedModes{
    664,
    Severity::error,
    "no modes to restore",
    "M72 brings back the modes that M70 saved in the same subprogram, and none are saved there (or "
    "M71 has made them invalid).",
    "Write M70 before M72, in the same subprogram.",
    "M72\nM2\n"};

inline constexpr ErrorPage kNoReturnToRestoreAt{
    665,
    Severity::error,
    "M73 outside a subprogram",
    "M73 saves the modes and brings them back as its subprogram returns. The main program does not "
    "return.",
    "Use M70 and M72 in the main program.",
    "M73\nM2\n"};

inline constexpr std::array kSwitchesPages{&kSurfaceSpeedWithoutS,
                                           &kNegativeMostSpeed,
                                           &kOrientWay,
                                           &kOrientTime,
                                           &kNoSpeedForFeed,
                                           &kFeedOfStoppedSpindle,
                                           &kToolNumberMissing,
                                           &kSwitchValue,
                                           &kChannelMissing,
                                           &kChannelOutOfRange,
                                           &kOutputValueMissing,
                                           &kInputMissing,
                                           &kWaitKind,
                                           &kWaitTime,
                                           &kNoSavedModes,
                                           &kNoReturnToRestoreAt};

}  // namespace kerf::errors
