// Pages of expressions and what they work out.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kBracketNotClosed{420,
                                             Severity::error,
                                             "']' expected",
                                             "Each '[' needs its ']' on the same line.",
                                             "Close the bracket.",
                                             "G0 X[1+2\nM2\n"};

inline constexpr ErrorPage kEmptyExpression{421,
                                            Severity::error,
                                            "empty expression",
                                            "There is nothing between '[' and ']'.",
                                            "Write the value.",
                                            "G0 X[]\nM2\n"};

inline constexpr ErrorPage kOperandExpected{
    422,
    Severity::error,
    "operand expected",
    "An operator needs a value on both sides.",
    "Write the value that is missing, or take the operator out.",
    "G0 X[1+]\nM2\n"};

inline constexpr ErrorPage kOperatorExpected{
    423,
    Severity::error,
    "operator expected",
    "Two values stand beside each other, or what is between them is no operator. Operators are + - "
    "* / ** MOD, EQ NE GT GE LT LE and AND OR XOR.",
    "Write an operator between the values or close the bracket.",
    "G0 X[1 2]\nM2\n"};

inline constexpr ErrorPage kUnknownFunction{
    424,
    Severity::error,
    "unknown function",
    "The functions are ABS ACOS ASIN ATAN COS EXISTS EXP FIX FUP LN ROUND SIN SQRT TAN; Fanuc has "
    "BCD, BIN and POW besides.",
    "Correct the name, or put the function together from those there are.",
    "G0 X[SINH[1]]\nM2\n"};

inline constexpr ErrorPage kFunctionBracket{425,
                                            Severity::error,
                                            "'[' expected behind a function",
                                            "The argument of a function stands in [ ]: SIN[30].",
                                            "Put the argument in [ ].",
                                            "G0 X[SIN 30]\nM2\n"};

inline constexpr ErrorPage kFunctionForm{
    426,
    Severity::error,
    "function with the wrong arguments",
    "ATAN takes the lengths of both legs: ATAN[y]/[x]. EXISTS takes a variable: EXISTS[#<name>]. "
    "POW takes base and exponent: POW[a,b]. All others take one value.",
    "Write the function in its form.",
    "G0 X[ATAN[1]]\nM2\n"};

inline constexpr ErrorPage kNestedTooDeep{
    427,
    Severity::error,
    "brackets nested too deep",
    "Brackets, functions and ## may be nested 64 levels deep.",
    "Work out a part of the expression into a variable first.",
    "G0 X[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1\nM2\n"};

inline constexpr ErrorPage kDivisionByZero{
    428,
    Severity::error,
    "division by zero",
    "The right side of '/' or MOD is 0.",
    "Check the divisor (o100 if [#1 NE 0]) before dividing by it.",
    "G0 X[1/0]\nM2\n"};

inline constexpr ErrorPage kNegativeRoot{
    429,
    Severity::error,
    "square root of a negative number",
    "SQRT takes values from 0 on.",
    "Correct the argument; ABS gives the value without its sign.",
    "G0 X[SQRT[-4]]\nM2\n"};

inline constexpr ErrorPage kArcFunctionRange{
    430,
    Severity::error,
    "argument outside -1 to 1",
    "ASIN and ACOS take values from -1 to 1.",
    "Correct the argument. A ratio of two lengths that rounding lifts a little above 1 is better "
    "taken by ATAN[a]/[b].",
    "G0 X[ACOS[1.5]]\nM2\n"};

inline constexpr ErrorPage kLogarithmRange{431,
                                           Severity::error,
                                           "logarithm of zero or less",
                                           "LN takes values greater than 0.",
                                           "Correct the argument.",
                                           "G0 X[LN[0]]\nM2\n"};

inline constexpr ErrorPage kFractionalPower{
    432,
    Severity::error,
    "negative number to a fractional power",
    "A negative number has powers with a whole exponent only.",
    "Correct the base or the exponent.",
    "G0 X[[-8]**0.5]\nM2\n"};

inline constexpr ErrorPage kNotFinite{
    433,
    Severity::error,
    "result not finite",
    "The result is too large for a number, or the function has no value there.",
    "Correct the expression: a division by a very small number is the usual cause.",
    "G0 X[EXP[1000]]\nM2\n"};

inline constexpr ErrorPage kNotABitPattern{
    434,
    Severity::error,
    "too large for AND, OR, XOR",
    "In Fanuc's custom macro B these work on the bits of whole numbers of 32 bits.",
    "Correct the values.",
    "#1=10000000000 AND 1\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kNotDecimalDigits{435,
                                             Severity::error,
                                             "not eight decimal digits",
                                             "BCD takes a whole number of at most eight digits, "
                                             "BIN one whose hexadecimal digits are all 0 to 9.",
                                             "Correct the value.",
                                             "#1=BIN[10]\nM2\n",
                                             "fanuc"};

inline constexpr std::array kExpressionsPages{
    &kBracketNotClosed, &kEmptyExpression, &kOperandExpected,  &kOperatorExpected,
    &kUnknownFunction,  &kFunctionBracket, &kFunctionForm,     &kNestedTooDeep,
    &kDivisionByZero,   &kNegativeRoot,    &kArcFunctionRange, &kLogarithmRange,
    &kFractionalPower,  &kNotFinite,       &kNotABitPattern,   &kNotDecimalDigits};

}  // namespace kerf::errors
