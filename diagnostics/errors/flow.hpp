// Pages of o-words: which line is next.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kNoLabel{500,
                                    Severity::error,
                                    "O without a label",
                                    "O begins an o-word or a program number, and both need a "
                                    "label: a number, a <name> or, for calls, an [expression].",
                                    "Write the label, as in `o100 call` or `o<drill> call`.",
                                    "O\nM2\n"};

inline constexpr ErrorPage kUnknownOWord{
    501,
    Severity::error,
    "unknown o-word",
    "Behind the label one of these is expected: sub, endsub, return, call, if, elseif, else, "
    "endif, while, endwhile, do, repeat, endrepeat, break, continue. Nothing behind the number "
    "makes it a program number.",
    "Correct the spelling.",
    "o100 frobnicate\nM2\n"};

inline constexpr ErrorPage kOWordNotFirst{502,
                                          Severity::error,
                                          "o-word behind other words",
                                          "An o-word says which line is next and stands alone on "
                                          "its line; only a line number may come before it.",
                                          "Give the o-word a line of its own.",
                                          "G0 X5 o100 call\nM2\n"};

inline constexpr ErrorPage kTextBehindStatement{
    503,
    Severity::error,
    "text behind a flow statement",
    "Only a comment may follow an o-word or a macro statement and its values.",
    "Give the rest a line of its own.",
    "o100 if [1] G0 X1\no100 endif\nM2\n"};

inline constexpr ErrorPage kNestedSub{
    504,
    Severity::error,
    "sub inside a sub",
    "Subprograms cannot be defined inside each other; they may call each other.",
    "Close the first sub with endsub before the next one begins.",
    "o100 sub\no200 sub\no200 endsub\no100 endsub\nM2\n"};

inline constexpr ErrorPage kNoClose{
    505,
    Severity::error,
    "structure that is never closed",
    "An if, while, do, repeat or sub has no statement that closes it before the program or the "
    "structure around it ends.",
    "Write endif, endwhile, while, endrepeat or endsub with the same label.",
    "o100 if [1 GT 0]\nG0 X1\nM2\n"};

inline constexpr ErrorPage kNoOpener{506,
                                     Severity::error,
                                     "close or branch without an opener",
                                     "An else, elseif, endif, endwhile, endrepeat or endsub "
                                     "belongs to no open structure with its label.",
                                     "Write the opening statement, or take this one out.",
                                     "o100 endif\nM2\n"};

inline constexpr ErrorPage kWrongLabel{
    507,
    Severity::error,
    "structure closed with another label",
    "A structure is opened under one label and closed under another.",
    "Use the same label at both ends.",
    "#1=0\no100 while [#1 LT 1]\n#1=[#1+1]\no101 endwhile\nM2\n"};

inline constexpr ErrorPage kBranchAfterElse{
    508,
    Severity::error,
    "branch behind else",
    "else is the last branch of an if: what follows it could never run.",
    "Put elseif before else, and write else once.",
    "o1 if [1]\no1 else\no1 else\no1 endif\nM2\n"};

inline constexpr ErrorPage kOutsideLoop{
    509,
    Severity::error,
    "break or continue outside its loop",
    "break and continue name, by their label, a while, do or repeat loop that they stand in.",
    "Use the label of a loop around the statement.",
    "o100 break\nM2\n"};

inline constexpr ErrorPage kOutsideSub{
    510,
    Severity::error,
    "return outside a sub",
    "return ends a subprogram and stands between sub and endsub.",
    "Take it out, or end the program with M2.",
    "o100 return\nM2\n"};

inline constexpr ErrorPage kSubNotFound{
    511,
    Severity::error,
    "subprogram not found",
    "The called sub is neither in the program nor in a file of its name beside the program.",
    "Correct the name, or put the file (NAME.ngc, lower case) into the program's folder.",
    "o777 call [1]\nM2\n"};

inline constexpr ErrorPage kSubTwice{
    512,
    Severity::error,
    "subprogram defined twice",
    "Two subprograms of one text have the same label, so a call could mean either.",
    "Give each its own label.",
    "o3 sub\no3 endsub\no3 sub\no3 endsub\nM2\n"};

inline constexpr ErrorPage kTooDeep{
    513,
    Severity::error,
    "calls nested too deep",
    "Each call inside a subprogram needs a place to return to, and there are 32. A subprogram that "
    "calls itself without end gets here.",
    "Let the recursion end, or use a loop.",
    "M98 P100\nM2\nO100\nM98 P100\nM99\n"};

inline constexpr ErrorPage kTooManyArguments{
    514,
    Severity::error,
    "too many arguments",
    "A call passes at most 30 values, #1 to #30.",
    "Pass fewer values, or leave some in global parameters.",
    "o1 sub\no1 endsub\no1 call [1] [2] [3] [4] [5] [6] [7] [8] [9] [10] [11] [12] [13] [14] [15] "
    "[16] [17] [18] [19] [20] [21] [22] [23] [24] [25] [26] [27] [28] [29] [30] [31]\nM2\n"};

inline constexpr ErrorPage kEndlessLoop{
    515,
    Severity::error,
    "endless loop",
    "So many lines have run since the last motion that the loop can be taken to have no end.",
    "Correct the loop's condition or what it counts.",
    "o100 while [1]\no100 endwhile\nM2\n"};

inline constexpr ErrorPage kNoCondition{
    516,
    Severity::error,
    "condition missing",
    "if, elseif, while, IF and WHILE need a condition and repeat a count in square brackets.",
    "Write it, as in `o100 if [#1 GT 5]`.",
    "o1 if\no1 endif\nM2\n"};

inline constexpr ErrorPage kNegativeCount{
    517,
    Severity::warning,
    "negative repeat count",
    "A loop that is to run a negative number of times is not run at all.",
    "Correct the count.",
    "o1 repeat [-1]\no1 endrepeat\nM2\n"};

inline constexpr ErrorPage kStructuresTooDeep{518,
                                              Severity::error,
                                              "structures nested too deep",
                                              "At most 64 structures may stand inside each other.",
                                              "Move inner parts into subprograms.",
                                              "o100 if [1]\n",
                                              "",
                                              {"o@ if [1]\n", 65}};

inline constexpr ErrorPage kAborted{
    561,
    Severity::error,
    "the program aborts itself",
    "The program reached a comment `(ABORT, message)`, with which it says that it cannot go on: "
    "most often a condition that it tests was not met.",
    "Do what the message says, or correct the condition under which the block is reached.",
    "(ABORT, no probe)\nM2\n"};

inline constexpr std::array kFlowPages{
    &kNoLabel,         &kUnknownOWord,  &kOWordNotFirst,     &kTextBehindStatement,
    &kNestedSub,       &kNoClose,       &kNoOpener,          &kWrongLabel,
    &kBranchAfterElse, &kOutsideLoop,   &kOutsideSub,        &kSubNotFound,
    &kSubTwice,        &kTooDeep,       &kTooManyArguments,  &kEndlessLoop,
    &kNoCondition,     &kNegativeCount, &kStructuresTooDeep, &kAborted};

}  // namespace kerf::errors
