// Pages of characters, comments and blanks.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kNonAscii{
    20,
    Severity::error,
    "non-ASCII character",
    "Outside comments a program has ASCII characters only. Letters that look alike, such as a "
    "Cyrillic X, come from copying out of documents.",
    "Type the character again, or take it out.",
    "G0 \xD0\xA5 1\nM2\n"};

inline constexpr ErrorPage kNotAMinus{
    21,
    Severity::error,
    "dash for a minus sign",
    "The character looks like a minus sign but is a dash, which word processors and web pages put "
    "in its place.",
    "Write '-'.",
    "G0 X\xE2\x88\x92"
    "1\nM2\n"};

inline constexpr ErrorPage kNoBreakSpace{
    22,
    Severity::error,
    "no-break space",
    "The character looks like a blank but is a no-break space, which word processors and web pages "
    "put in its place.",
    "Write a blank, or nothing: blanks mean nothing in a block.",
    "G0\xC2\xA0X1\nM2\n"};

inline constexpr ErrorPage kControlByte{
    23,
    Severity::error,
    "control character",
    "The byte is a control character, which no program needs. It shows a faulty transfer or a file "
    "that is not text.",
    "Take the byte out and see that the rest of the file is sound.",
    "G0 X1 \x01\nM2\n"};

inline constexpr ErrorPage kBadEncoding{
    24,
    Severity::error,
    "byte that is no character",
    "Outside comments a program has ASCII characters only; this byte is not even part of a UTF-8 "
    "character. The file may be in an old code page, or damaged.",
    "Type the character again, or save the file as ASCII or UTF-8.",
    "G0 X1 \xFF\nM2\n"};

inline constexpr ErrorPage kMisplacedCharacter{
    25,
    Severity::error,
    "character that may not stand here",
    "The character has no meaning at this place of a block.",
    "Take the character out or correct it.",
    "G0 X1 ?\nM2\n"};

inline constexpr ErrorPage kForeignSyntax{
    26,
    Severity::error,
    "character of another control's language",
    "'=' stands in programs for Siemens controls, '*' before the checksums of 3D printers, and '$' "
    "before commands of grbl.",
    "Have the CAM system write G-code for RS274/NGC or Fanuc.",
    "G0 X=10\nM2\n"};

inline constexpr ErrorPage kUnmatchedParenthesis{27,
                                                 Severity::error,
                                                 "')' without '('",
                                                 "A comment ends here that was never opened.",
                                                 "Take ')' out, or write the '(' that is missing.",
                                                 "G0 X1 )\nM2\n"};

inline constexpr ErrorPage kMisplacedSlash{
    28,
    Severity::error,
    "'/' inside a block",
    "Outside expressions '/' marks a block that may be left out, and stands at its start.",
    "Move '/' to the start of the block; in a calculation write [ ] round it.",
    "G0 X1 /\nM2\n"};

inline constexpr ErrorPage kMisplacedPercent{
    29,
    Severity::error,
    "'%' inside a block",
    "'%' opens and closes the program and stands alone on its line.",
    "Give '%' a line of its own, or take it out.",
    "G0 X1 %\nM2\n"};

inline constexpr ErrorPage kUnclosedComment{
    30,
    Severity::error,
    "comment not closed",
    "The comment that opens here has no ')' on its line. It is not taken to end with the line: "
    "what was meant to be run might hide in it.",
    "Write ')' where the comment ends.",
    "G0 X1 (to the left\nM2\n"};

inline constexpr ErrorPage kNestedComment{
    31,
    Severity::error,
    "'(' inside a comment",
    "Comments do not nest: the first ')' would end the comment, and the rest of the text would be "
    "run.",
    "Write [ ] inside the comment, or take the inner parentheses out.",
    "G0 X1 (to (the) left)\nM2\n"};

inline constexpr ErrorPage kCommentInNumber{
    32,
    Severity::error,
    "comment inside a number",
    "A comment splits a number in two. Whether one number is meant or two cannot be told.",
    "Move the comment in front of the word or behind it.",
    "G0 X1(comment)0\nM2\n"};

inline constexpr ErrorPage kSemicolonAtEnd{
    33,
    Severity::warning,
    "text after ';' is a comment",
    "The line ends with ';' and has another one before it. Where ';' is meant as the end of block, "
    "as Fanuc's manuals print it, the text between the two is not run.",
    "Put each block on a line of its own.",
    "G0 X1; Y2;\nM2\n"};

inline constexpr ErrorPage kNumberedBlockDelete{
    34,
    Severity::warning,
    "numbered block delete",
    "'/1' to '/9' belong to nine switches of a Fanuc control, a plain '/' to the first of them; "
    "RS274/NGC has one switch. The block runs unless `--block-delete` names its number or none.",
    "Write '/', or choose the Fanuc dialect.",
    "/2 G0 X1\nM2\n"};

inline constexpr ErrorPage kLineNumberWithPoint{
    35,
    Severity::warning,
    "line number with a decimal part",
    "N numbers a block, by a whole number. The decimals are passed over.",
    "Write the number without decimals.",
    "N1.5 G0 X1\nM2\n"};

inline constexpr ErrorPage kBlankInNumber{
    36,
    Severity::warning,
    "blank inside a number",
    "Blanks mean nothing in a block, so the digits on both sides of this one are read as one "
    "number. A forgotten address letter looks the same.",
    "Take the blank out, or write the letter that is missing.",
    "G0 X1 0\nM2\n"};

inline constexpr ErrorPage kFineNumber{
    37,
    Severity::warning,
    "coordinate below the resolution",
    "A coordinate that is smaller than 1e-9 mm or inches is what rounding left in "
    "the program that wrote it. It is read as 0. This is said once for a program.",
    "Write 0; let the postprocessor write four or five decimals.",
    "G0 X0.00000000004\nM2\n"};

inline constexpr std::array kCharactersPages{
    &kFineNumber,           &kNonAscii,        &kNotAMinus,          &kNoBreakSpace,
    &kControlByte,          &kBadEncoding,     &kMisplacedCharacter, &kForeignSyntax,
    &kUnmatchedParenthesis, &kMisplacedSlash,  &kMisplacedPercent,   &kUnclosedComment,
    &kNestedComment,        &kCommentInNumber, &kSemicolonAtEnd,     &kNumberedBlockDelete,
    &kLineNumberWithPoint,  &kBlankInNumber};

}  // namespace kerf::errors
