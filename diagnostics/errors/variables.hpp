// Pages of variables: numbered and named parameters, and their assignment.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kVariableExpected{
    400,
    Severity::error,
    "variable number expected",
    "'#' is followed by the number of a variable, by an expression in [ ] that gives it, or by a "
    "name in < >.",
    "Write the number or name. A comment begins with ( or ;.",
    "G0 X#\nM2\n"};

inline constexpr ErrorPage kNoSuchVariable{
    401,
    Severity::error,
    "variable that does not exist",
    "RS274/NGC has the variables #1 to #5601; Fanuc has #0 to #33, #100 to #199, #500 to #999 and "
    "some system variables from #1000 on.",
    "Use a number that exists; #100 to #199 are free in both dialects.",
    "#99999=1\nM2\n"};

inline constexpr ErrorPage kVariableNotWhole{
    402,
    Severity::error,
    "variable number with decimals",
    "A variable is chosen by a whole number.",
    "Round the expression (ROUND, FIX, FUP), or correct it.",
    "#1.5=1\nM2\n"};

inline constexpr ErrorPage kReadOnlyVariable{
    403,
    Severity::error,
    "write to a read-only variable",
    "The variable shows the machine's state (position, tool, active codes) and follows it by "
    "itself.",
    "Write to a variable of your own. The state is changed by its code: G10, G92, M6.",
    "#5420=1\nM2\n"};

inline constexpr ErrorPage kVariableNotSet{
    404,
    Severity::error,
    "variable that was never set",
    "A named variable exists once a value was assigned to it. Names without a leading '_' live "
    "only inside the subprogram that set them.",
    "Set it before it is read, correct its spelling, or begin its name with '_' to share it "
    "between subprograms. EXISTS[#<name>] tells whether it was set.",
    "G0 X#<not_set>\nM2\n"};

inline constexpr ErrorPage kNameNotClosed{
    405,
    Severity::error,
    "name that is not closed",
    "The name of a variable stands between < and > on one line.",
    "Write '>' behind the name.",
    "G0 X#<depth\nM2\n"};

inline constexpr ErrorPage kEqualsExpected{
    406,
    Severity::error,
    "'=' expected",
    "A variable at the start of a block is assigned a value: #1=2. Elsewhere it is the value of "
    "the letter before it.",
    "Write '=' and the value, or the letter that the variable belongs to.",
    "#1 2\nM2\n"};

inline constexpr ErrorPage kValueExpected{
    407,
    Severity::error,
    "value expected",
    "An assignment has a number, a variable, a function or an expression in [ ] behind its '='.",
    "Write the value, or take the assignment out.",
    "#1=\nM2\n"};

inline constexpr ErrorPage kOperatorOutsideBrackets{
    408,
    Severity::error,
    "operator outside of brackets",
    "In RS274/NGC an expression stands in [ ]: #1=[#2+3]. Without them only Fanuc reads it.",
    "Put the expression in [ ], or choose the Fanuc dialect (--dialect fanuc).",
    "#2=1\n#1=#2+3\nM2\n"};

inline constexpr ErrorPage kAssignmentBesideWords{
    409,
    Severity::error,
    "assignment beside other words",
    "In Fanuc's custom macro B an assignment stands alone in its block.",
    "Give the assignment a block of its own.",
    "#1=5 G0 X1\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kStaleRead{
    410,
    Severity::warning,
    "variable set and used in one block",
    "All values of a block are read before its assignments take effect, so the variable still had "
    "its value from the block before.",
    "Put the assignment into the block before if the new value is meant.",
    "#1=5 G0 X#1\nM2\n"};

inline constexpr ErrorPage kAssignmentAmongWords{
    411,
    Severity::warning,
    "assignment and words in one block",
    "The assignment takes effect when the block has been carried out, wherever it stands in it. "
    "Other controls refuse such a block.",
    "Give the assignment a block of its own.",
    "G0 X1 #1=5\nM2\n"};

inline constexpr ErrorPage kUnsetVariable{
    412,
    Severity::warning,
    "variable that was never set",
    "The program reads a numbered variable before anything has set it. It counts as 0. In a "
    "subprogram #1 to #30 are those of the call and may be left out.",
    "Set the variable first, or correct its number.",
    "G0 X#100\nM2\n"};

inline constexpr ErrorPage kTooManyNames{413,
                                         Severity::error,
                                         "too many named variables",
                                         "Each name keeps its value until its subprogram or the "
                                         "program ends. A million of them are kept.",
                                         "Use numbered variables, or fewer names.",
                                         "",
                                         "",
                                         {"#<n@>=1\n", 1'000'001}};

inline constexpr std::array kVariablesPages{
    &kVariableExpected,        &kNoSuchVariable,        &kVariableNotWhole, &kReadOnlyVariable,
    &kVariableNotSet,          &kNameNotClosed,         &kEqualsExpected,   &kValueExpected,
    &kOperatorOutsideBrackets, &kAssignmentBesideWords, &kStaleRead,        &kAssignmentAmongWords,
    &kUnsetVariable,           &kTooManyNames};

}  // namespace kerf::errors
