// Pages of a file as a whole: what it is, how it begins and ends.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kNotText{
    1,
    Severity::error,
    "the file is not text",
    "The file begins with a byte that no text has, so it is most likely a drawing, an archive or a "
    "program in a binary format.",
    "Load the part program, not the file that it was made from.",
    "\x01\x02\n"};

inline constexpr ErrorPage kUtf16{
    2,
    Severity::error,
    "the file is UTF-16",
    "The file was stored with two bytes for each character. Part programs are ASCII, comments may "
    "be UTF-8.",
    "Save the file as UTF-8 or ASCII: editors offer it under 'Save as' or 'Encoding'.",
    "\xFF\xFEG\n"};

inline constexpr ErrorPage kHeidenhain{
    3,
    Severity::error,
    "HEIDENHAIN program",
    "The file is a conversational program of a HEIDENHAIN control (BEGIN PGM ... END PGM), a "
    "language of its own.",
    "Have the CAM system write ISO G-code for the part.",
    "BEGIN PGM PART MM\nL X+10 FMAX\nEND PGM PART MM\n"};

inline constexpr ErrorPage kEmptyProgram{
    4,
    Severity::error,
    "the program is empty",
    "The file has no block at all. A file that was cut short on its way here looks like this.",
    "Load the file again.",
    "(nothing)\n"};

inline constexpr ErrorPage kByteOrderMark{
    5,
    Severity::warning,
    "byte order mark ignored",
    "The file begins with the three bytes that some editors put before UTF-8 text. They mean "
    "nothing in a program.",
    "Nothing needs to be done; save the file as UTF-8 without BOM to be rid of the warning.",
    "\xEF\xBB\xBFG0 X1\nM2\n"};

inline constexpr ErrorPage kLineTooLong{
    6,
    Severity::error,
    "line too long",
    "A line may have 65536 bytes. A longer one shows that the file is no part program, or that its "
    "line ends were lost.",
    "See whether the file was converted wrongly on its way here.",
    "",
    "",
    {" ", 65'537}};

inline constexpr ErrorPage kPercentNotAlone{
    7,
    Severity::error,
    "'%' with other text",
    "A '%' ends the program (the first one opens it, and a title may follow that). Behind the "
    "closing one only a comment may stand on the line.",
    "Give '%' a line of its own, or take it out.",
    "%\nG0 X1\n% G0 X2\n%\n"};

inline constexpr ErrorPage kUnclosedPercent{
    8,
    Severity::warning,
    "no closing '%'",
    "The program is opened by a '%' line and so should be closed by one. The end of the file may "
    "be missing.",
    "See that the file is complete, and close it with a '%' line.",
    "%\nG0 X1\n"};

inline constexpr ErrorPage kNoProgramEnd{
    9,
    Severity::warning,
    "no end of program",
    "The last block is neither M2 nor M30 nor '%'. The end of the file may be missing: a transfer "
    "that broke off looks like this.",
    "See that the file is complete, and end it with M2 or M30.",
    "G0 X1\n"};

inline constexpr ErrorPage kTextAfterPercent{
    10,
    Severity::warning,
    "text after the closing '%'",
    "What stands behind the closing '%' does not belong to the program and is never run.",
    "Take the text out, or move '%' behind it if it is meant to be run.",
    "%\nG0 X1\n%\nG0 X2\n"};

inline constexpr ErrorPage kBlocksAfterEnd{
    11,
    Severity::warning,
    "blocks after the program's end",
    "M2 or M30 has ended the program; the blocks behind it are never run.",
    "Take the blocks out, or the M2 that stands too early.",
    "G0 X1\nM2\nG0 X2\n"};

inline constexpr ErrorPage kTooManyErrors{
    12,
    Severity::warning,
    "too many errors",
    "So many errors were found that the rest of the program is not read.",
    "Mend the first errors and check again: many of the later ones often follow from them.",
    "",
    "",
    {"G123\n", 101}};

inline constexpr ErrorPage kTooManyWarnings{
    13,
    Severity::warning,
    "too many warnings",
    "More than 100 warnings were given; the others are not shown. Errors are shown all the same.",
    "Mend what the warnings have in common, often a setting of the post-processor.",
    "",
    "",
    {"G5 P0\n", 102}};

inline constexpr ErrorPage kMarkup{
    14,
    Severity::error,
    "the file is HTML or XML",
    "The file begins with '<'. A download that failed leaves a web page under the program's name.",
    "Load the file again, and look at it in an editor first.",
    "<!DOCTYPE html>\n"};

inline constexpr ErrorPage kEndMark{
    15,
    Severity::warning,
    "Ctrl-Z at the end",
    "The text ends with the byte 0x1A, with which old systems and some transfers mark the end of a "
    "file. It is ignored; in front of other text it is an error.",
    "Nothing needs to be done; delete the byte to be rid of the warning.",
    "G0 X1\nM2\n\x1A"};

inline constexpr std::array kFilesPages{
    &kNotText,        &kUtf16,           &kHeidenhain,      &kEmptyProgram, &kByteOrderMark,
    &kLineTooLong,    &kPercentNotAlone, &kUnclosedPercent, &kNoProgramEnd, &kTextAfterPercent,
    &kBlocksAfterEnd, &kTooManyErrors,   &kTooManyWarnings, &kMarkup,       &kEndMark};

}  // namespace kerf::errors
