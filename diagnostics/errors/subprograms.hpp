// Pages of calls and subprograms.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kM98WithoutP{519,
                                        Severity::error,
                                        "call without P",
                                        "M98, G65 and G66 name the subprogram in P.",
                                        "Write P and the program's number.",
                                        "M98\nM2\n"};

inline constexpr ErrorPage kProgramNumber{520,
                                          Severity::error,
                                          "wrong program number",
                                          "A program number is a whole number from 1 to 99999999.",
                                          "Correct the number.",
                                          "M98 P1.5\nM2\n"};

inline constexpr ErrorPage kRepeatCount{
    521,
    Severity::error,
    "wrong repeat count",
    "L says how often the subprogram runs: a whole number from 0 to 99999999.",
    "Correct L.",
    "M98 P100 L1.5\nM2\nO100\nM99\n"};

inline constexpr ErrorPage kM99InMain{522,
                                      Severity::warning,
                                      "M99 in the main program",
                                      "On a machine M99 outside a subprogram repeats the program "
                                      "without end. Here it ends it, as M2 does.",
                                      "End the program with M2 or M30.",
                                      "G0 X1\nM99\n"};

inline constexpr ErrorPage kNoM99{523,
                                  Severity::error,
                                  "subprogram without M99",
                                  "A subprogram called with M98 or G65 must return with M99 before "
                                  "the next program number or the end of the text.",
                                  "Write M99 at its end.",
                                  "M98 P100\nM2\nO100\nG0 X1\n"};

inline constexpr ErrorPage kWrongCall{
    524,
    Severity::error,
    "wrong kind of call",
    "A subprogram that begins with `o100 sub` is called with `o100 call`, one that begins with "
    "`O100` alone with M98 P100.",
    "Use the call that fits.",
    "o100 sub\no100 endsub\nM98 P100\nM2\n"};

inline constexpr ErrorPage kOWordInFanuc{
    527,
    Severity::error,
    "o-word in the Fanuc dialect",
    "sub, call, if, while and the other o-words are RS274/NGC. The Fanuc dialect has M98, G65, IF "
    "and WHILE.",
    "Choose the rs274 dialect, or write the statement as a macro.",
    "o100 if [1]\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kComputedSub{
    528,
    Severity::error,
    "sub with a computed label",
    "The label of a definition must be known when the text is read; only calls may compute it.",
    "Write a number or a <name>.",
    "o[1+1] sub\nM2\n"};

inline constexpr ErrorPage kM99InSub{529,
                                     Severity::error,
                                     "M99 in a sub",
                                     "A subprogram that begins with `o100 sub` returns with return "
                                     "or endsub. M99 belongs to those that are called with M98.",
                                     "Write `o100 return`.",
                                     "o1 sub\nM99\no1 endsub\no1 call\nM2\n"};

inline constexpr ErrorPage kSubRefused{
    560,
    Severity::error,
    "subprogram's file not read",
    "There is a file of the subprogram's name beside the program, but it is a symbolic link that "
    "leads out of the program's folder. What a program calls lies beside it.",
    "Put the file itself into the program's folder.",
    "o<linked> call\nM2\n"};

inline constexpr std::array kSubprogramsPages{
    &kM98WithoutP, &kProgramNumber, &kRepeatCount, &kM99InMain, &kNoM99,
    &kWrongCall,   &kOWordInFanuc,  &kComputedSub, &kM99InSub,  &kSubRefused};

}  // namespace kerf::errors
