#include "parser/reader/block_warnings.hpp"

#include <string>
#include <string_view>

#include "diagnostics/errors/pages.hpp"
#include "parser/dialects/fanuc/fanuc_codes.hpp"
#include "parser/moves/arc_geometry.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

bool has_words_beside_number(const BlockWords& block) {
  return block.g_count + block.m_count != 0 || (block.present & ~letter_bit('N')) != 0;
}

}  // namespace

void warn_about(const BlockWords& block, LineInDialect where, SaidOnce& said,
                diagnostics::DiagnosticList& diagnostics) {
  const std::uint32_t line = where.number;
  if (block.blank_in_number != 0) {
    const std::string_view rest = block.line.substr(block.blank_in_number - 1, 40);
    diagnostics.add({line, block.blank_in_number}, errors::kBlankInNumber,
                    joined({"a number contains a blank: ", quoted(rest), " is read as one"}));
  }
  if (block.fine_number != 0 && !said.fine_number) {
    said.fine_number = true;
    diagnostics.add({line, block.fine_number}, errors::kFineNumber,
                    joined({named(static_cast<char>(block.line[block.fine_number - 1] & ~0x20)),
                            ": the value is below the resolution of 1e-9, rounded to 0"}));
  }
  if (block.stale_read != 0) {
    const std::string_view rest = block.line.substr(block.stale_read - 1, 40);
    diagnostics.add({line, block.stale_read}, errors::kStaleRead,
                    joined({"the variable at ", quoted(rest),
                            " is set in the same block: its value from before is used"}));
  } else if (!rules_of(where.dialect).assigns_at_once && block.assignment != 0 &&
             has_words_beside_number(block)) {
    diagnostics.add({line, block.assignment}, errors::kAssignmentAmongWords,
                    "the assignment takes effect after the words of its block");
  }
  if (block.numbered_delete && !rules_of(where.dialect).numbered_delete) {
    diagnostics.add({line, 1}, errors::kNumberedBlockDelete,
                    joined({"numbered block delete '", block.line.substr(block.line.find('/'), 2),
                            "' belongs to the Fanuc dialect"}));
  }
  if (block.line_number_decimal) {
    diagnostics.add({line, block.word('N').offset + 1}, errors::kLineNumberWithPoint,
                    joined({upper(block.text(block.word('N')).substr(0, 40)),
                            ": the line number has a decimal part"}));
  }
  if (block.remark != 0) {
    const std::string_view remark = block.line.substr(block.remark);
    const std::size_t last = remark.find_last_not_of(" \t");
    const bool is_block = rules_of(where.dialect).blocks_behind_semicolon && reads_as_block(remark);
    if (!is_block && last != std::string_view::npos && remark[last] == ';') {
      diagnostics.add({line, block.remark}, errors::kSemicolonAtEnd,
                      joined({"the text after ';' is taken as a comment: ", quoted(remark)}));
    }
  }
}

void warn_of_missing_point(const BlockWords& block, const ModalState& state, std::uint32_t line,
                           SaidOnce& said, diagnostics::DiagnosticList& diagnostics) {
  for (std::size_t axis = 0; axis < 3 && !said.no_point; ++axis) {
    const char letter = axis_letter(axis);
    // 0 is 0 in both readings.
    if (!block.has(letter) || (block.pointed & letter_bit(letter)) != 0 ||
        block.value(letter) == 0.0) {
      continue;
    }
    said.no_point = true;
    const Word& word = block.word(letter);
    diagnostics.add(
        {line, word.offset + 1}, errors::kNoDecimalPoint,
        joined({upper(block.text(word).substr(0, 40)), " without a decimal point is read as ",
                shortest(word.value), state.units == Units::inch ? " inches" : " mm"}));
  }
}

}  // namespace kerf::parser
