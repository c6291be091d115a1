// Pages of the statements of custom macro B.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kLabelMissing{
    530,
    Severity::error,
    "sequence number not found",
    "GOTO and M99 P jump to the block that begins with N and that number, in the same program.",
    "Correct the number, or give the block its N.",
    "GOTO 10\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kLoopNumber{531,
                                       Severity::error,
                                       "wrong loop number",
                                       "DO and END are numbered 1, 2 or 3.",
                                       "Use one of these.",
                                       "WHILE [1 EQ 0] DO4\nEND4\nM30\n",
                                       "fanuc"};

inline constexpr ErrorPage kNoDo{532,
                                 Severity::error,
                                 "WHILE without DO",
                                 "WHILE [..] is followed by DO1, DO2 or DO3.",
                                 "Write DO and a number.",
                                 "WHILE [1 EQ 0]\nM30\n",
                                 "fanuc"};

inline constexpr ErrorPage kNoThen{
    533,
    Severity::error,
    "IF without THEN or GOTO",
    "The condition of IF is followed by GOTO and a sequence number or by THEN and a statement.",
    "Write what is to happen.",
    "IF [1 EQ 1] G0 X1\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kLoopsCross{534,
                                       Severity::error,
                                       "loops that cross",
                                       "A loop that begins inside another one must end inside it.",
                                       "END the inner loop first.",
                                       "WHILE [1 EQ 0] DO1\nWHILE [1 EQ 0] DO2\nEND1\nEND2\nM30\n",
                                       "fanuc"};

inline constexpr ErrorPage kLoopNumberInUse{
    535,
    Severity::error,
    "loop number in use",
    "Loops inside each other need different numbers.",
    "Use another of 1, 2 and 3.",
    "WHILE [1 EQ 0] DO1\nWHILE [1 EQ 0] DO1\nEND1\nEND1\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kJumpIntoLoop{
    536,
    Severity::error,
    "jump into a loop",
    "GOTO may leave a loop, but not enter one: its condition would not have been looked at.",
    "Jump to a block outside the loop.",
    "GOTO 10\nWHILE [1 EQ 0] DO1\nN10 G0 X1\nEND1\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kTargetNumber{538,
                                         Severity::error,
                                         "wrong sequence number",
                                         "A sequence number is a whole number from 1 to 999999999.",
                                         "Correct the number behind GOTO or P.",
                                         "GOTO 1.5\nM30\n",
                                         "fanuc"};

inline constexpr ErrorPage kArgument{539,
                                     Severity::error,
                                     "wrong macro argument",
                                     "G, L, N, O and P pass no values in G65 and G66.",
                                     "Use another letter.",
                                     "G65 P100 N5\nM30\nO100\nM99\n",
                                     "fanuc"};

inline constexpr ErrorPage kProgramTwice{
    540,
    Severity::error,
    "program number used twice",
    "Two programs of one text have the same number, so a call could mean either.",
    "Give each its own number.",
    "O1\nM98 P2\nM30\nO2\nM99\nO2\nM99\n",
    "fanuc"};

inline constexpr ErrorPage kRunsIntoProgram{
    541,
    Severity::warning,
    "program runs into the next one",
    "The program reached the number of the next program without M30, M2 or M99. It ends there.",
    "End it with M30.",
    "O1\nG0 X1\nO2\nG0 X2\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kThenForm{
    542,
    Severity::error,
    "IF in a form that is not supported",
    "Behind IF [..] THEN stands an assignment, GOTO or a block, in the same line. Another IF, a "
    "loop, and ELSE and ENDIF over several lines, as newer controls have them, are not supported.",
    "Join the conditions with AND, or jump around the blocks with IF [..] GOTO.",
    "#1=1\nIF [#1 EQ 1] THEN\n#2=3\nENDIF\nM30\n",
    "fanuc"};

inline constexpr ErrorPage kMacroAlarm{
    543,
    Severity::error,
    "the program raises an alarm",
    "A statement `#3000=n(TEXT)` was run, which stops a Fanuc control with alarm 3000+n and the "
    "text. Macros do so where they are called with arguments that they cannot use.",
    "See in the macro why: mostly an argument is missing or wrong.",
    "#3000=1(NO DEPTH)\nM30\n",
    "fanuc"};

inline constexpr std::array kMacrosPages{
    &kThenForm, &kMacroAlarm,   &kLabelMissing,    &kLoopNumber,   &kNoDo,
    &kNoThen,   &kLoopsCross,   &kLoopNumberInUse, &kJumpIntoLoop, &kTargetNumber,
    &kArgument, &kProgramTwice, &kRunsIntoProgram};

}  // namespace kerf::errors
