#include "parser/block_warnings.hpp"

#include <string>
#include <string_view>

#include "parser/errors/characters.hpp"
#include "parser/errors/files.hpp"
#include "parser/errors/variables.hpp"
#include "parser/errors/words.hpp"
#include "parser/fanuc/end_of_block.hpp"
#include "parser/text.hpp"

namespace kerf::parser {

namespace {

bool has_words_beside_number(const Block& block) {
  return block.g_count + block.m_count != 0 || (block.present & ~letter_bit('N')) != 0;
}

}  // namespace

void warn_about(const Block& block, LineInDialect where, DiagnosticList& diagnostics) {
  const std::uint32_t line = where.number;
  if (block.blank_in_number != 0) {
    const std::string_view rest = block.line.substr(block.blank_in_number - 1, 40);
    diagnostics.add({line, block.blank_in_number}, errors::kBlankInNumber,
                    joined({"a number contains a blank: ", quoted(rest), " is read as one"}));
  }
  if (block.stale_read != 0) {
    const std::string_view rest = block.line.substr(block.stale_read - 1, 40);
    diagnostics.add({line, block.stale_read}, errors::kStaleRead,
                    joined({"the variable at ", quoted(rest),
                            " is set in the same block: its value from before is used"}));
  } else if (where.dialect == Dialect::rs274 && block.assignment != 0 &&
             has_words_beside_number(block)) {
    diagnostics.add({line, block.assignment}, errors::kAssignmentAmongWords,
                    "the assignment takes effect behind the words of its block");
  }
  if (block.numbered_delete && where.dialect == Dialect::rs274) {
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
    const bool is_block = where.dialect == Dialect::fanuc && reads_as_block(remark);
    if (!is_block && last != std::string_view::npos && remark[last] == ';') {
      diagnostics.add({line, block.remark}, errors::kSemicolonAtEnd,
                      joined({"the text after ';' is taken as a comment: ", quoted(remark)}));
    }
  }
}

}  // namespace kerf::parser
