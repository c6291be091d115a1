// Pages of words and numbers.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kNumberExpected{
    40,
    Severity::error,
    "a number is expected",
    "Each address letter is followed by a number, by a parameter (#1) or by an expression in [ ].",
    "Write the number, or take the letter out.",
    "G0 X Y1\nM2\n"};

inline constexpr ErrorPage kMalformedNumber{
    41,
    Severity::error,
    "malformed number",
    "A number has at most one sign, then digits with at most one decimal point.",
    "Correct the number.",
    "G0 X1.2.3\nM2\n"};

inline constexpr ErrorPage kNegativeLineNumber{42,
                                               Severity::error,
                                               "negative line number",
                                               "N numbers a block and has no sign.",
                                               "Write the number without the sign, or leave N out.",
                                               "N-1 G0 X1\nM2\n"};

inline constexpr ErrorPage kUnexpectedAfterNumber{
    43,
    Severity::error,
    "character after a number",
    "The character cannot follow a number. A decimal comma and a sign behind the digits are the "
    "usual causes.",
    "Write '.' as the decimal separator and the sign before the digits.",
    "G0 X1,5\nM2\n"};

inline constexpr ErrorPage kAddressExpected{
    44,
    Severity::error,
    "number without a letter",
    "Each number belongs to an address letter, which stands before it.",
    "Write the letter that is missing, or take the number out.",
    "10 G0 X1\nM2\n"};

inline constexpr ErrorPage kLetterForDigit{
    45,
    Severity::error,
    "letter in place of a digit",
    "Where a digit should stand there is a letter that looks like one: O for 0, l for 1.",
    "Write the digit.",
    "G0 XO\nM2\n"};

inline constexpr ErrorPage kRepeatedWord{
    46,
    Severity::error,
    "word given twice",
    "The block has two words with the same letter. Which of the two was meant cannot be told; "
    "other controls silently take the last.",
    "Take one of the two out, or give each a block of its own.",
    "G0 X1 X2\nM2\n"};

inline constexpr ErrorPage kTooManyGCodes{
    47,
    Severity::error,
    "too many G codes",
    "A block may have up to 16 G codes.",
    "Put some of the codes in a block of their own.",
    "G17 G21 G40 G49 G54 G61 G80 G90 G91.1 G94 G0 G17 G17 G17 G17 G17 G17 X1\nM2\n"};

inline constexpr ErrorPage kTooManyMCodes{48,
                                          Severity::error,
                                          "too many M codes",
                                          "A block may have up to 4 M codes.",
                                          "Put some of the codes in a block of their own.",
                                          "M3 M6 M7 M0 M8 S1000 T1\nM2\n"};

inline constexpr ErrorPage kLineNumberNotFirst{
    49,
    Severity::error,
    "line number not at the start",
    "N numbers the block and stands before its other words. An N further on often shows that the "
    "line end between two blocks was lost.",
    "Begin a new line at N, or take it out.",
    "G0 X1 N20 G0 Y1\nM2\n"};

inline constexpr ErrorPage kMacroStatement{
    50,
    Severity::error,
    "macro statement",
    "IF, WHILE, GOTO and their like belong to Fanuc's custom macro B.",
    "Choose the Fanuc dialect (--dialect fanuc) where the program is one; RS274/NGC has O-words "
    "for the same (o100 if [...]).",
    "IF [#1 EQ 1] GOTO 10\nM2\n"};

inline constexpr ErrorPage kMisplacedExpression{
    51,
    Severity::error,
    "expression where none may stand",
    "'#' and '[' begin a value, which belongs to the letter before it.",
    "Write the letter that the value belongs to.",
    "[1+2]\nM2\n"};

inline constexpr ErrorPage kCornerWord{
    53,
    Severity::error,
    "comma before a word",
    "Fanuc controls take ',C' and ',R' at the end of a straight move as a chamfer or a rounding of "
    "the corner to the next move. Kerf does not.",
    "Have the CAM system write the chamfer as a line and the rounding as an arc.",
    "G1 X10 ,C2 F100\nM2\n"};

inline constexpr std::array kWordsPages{
    &kNumberExpected,  &kMalformedNumber,    &kNegativeLineNumber, &kUnexpectedAfterNumber,
    &kAddressExpected, &kLetterForDigit,     &kRepeatedWord,       &kTooManyGCodes,
    &kTooManyMCodes,   &kLineNumberNotFirst, &kMacroStatement,     &kMisplacedExpression,
    &kCornerWord};

}  // namespace kerf::errors
