#include "parser/flow/program_text.hpp"

#include <algorithm>
#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "diagnostics/fault.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

ProgramText::ProgramText(TextOrigin origin)
    : origin_(std::move(origin)), structure_(statements_, labels_, origin_.first_line) {
  anything_ = any_block_ = origin_.first_line > 1;
}

// '%' before anything else opens the text, a later one closes it.
bool ProgramText::take_percent(std::string_view text, std::size_t at) {
  if (at >= text.size() || text[at] != '%') {
    return false;
  }
  if (origin_.file != 0) {
    store_[store_.size() - 1].length = 0;  // of a file, it says nothing to the program that calls
  }
  if (anything_) {
    close();
  }
  return true;
}

void ProgramText::take(const NumberedLine& line) {
  const std::uint32_t index = store_.append(line);
  const std::string_view text = store_[index].view();
  const std::size_t first = skip_blanks(text, 0);
  if (first >= text.size() || text[first] == '(' || text[first] == ';' || line.too_long) {
    return;
  }
  if (take_percent(text, first)) {
    anything_ = true;
    return;
  }
  const bool first_block = !any_block_;
  anything_ = any_block_ = true;
  if (line.left_out) {
    return;
  }
  const BlockStart start = find_block_start(text);
  if (start.line_number && rules_of(origin_.dialect).macro_statements) {
    numbers_.add(*start.line_number, index, structure_.innermost());
  }
  if (may_be_statement(text, start.at, rules_of(origin_.dialect))) {
    take_statement(index, text, start.at);
    if (first_block && statements_.back().keyword == Keyword::program) {
      head_ = statements_.size() - 1;
    }
  }
}

std::uint32_t ProgramText::first_sub_line() const {
  const auto sub = std::find_if(statements_.begin(), statements_.end(),
                                [](const Statement& one) { return one.keyword == Keyword::o_sub; });
  return sub == statements_.end() ? 0 : number_of(sub->line);
}

void ProgramText::take_statement(std::uint32_t line, std::string_view text, std::size_t at) {
  const diagnostics::Expected<Statement> read = read_statement(text, at, origin_.dialect);
  if (read && read->keyword == Keyword::none) {
    return;
  }
  const auto index = static_cast<std::uint32_t>(statements_.size());
  Statement& statement =
      statements_.emplace_back(read ? *read : Statement{.keyword = Keyword::wrong});
  statement.line = line;
  store_[line].statement = index & 0x3FFFFFFFU;
  if (!read) {
    diagnostics::Fault& fault = *read.error();
    faults_.push_back({line, fault.offset, fault.page, std::move(fault.message)});
    return;
  }
  name_statement(index, text);
  structure_.take(index, faults_);
}

// Enters the label and what it defines.
void ProgramText::name_statement(std::uint32_t index, std::string_view text) {
  Statement& statement = statements_[index];
  if (statement.keyword >= Keyword::macro_if) {
    return;
  }
  statement.label = labels_.index_of(plain_label(text, statement));
  const bool sub = statement.keyword == Keyword::o_sub;
  if (statement.keyword == Keyword::program) {
    programs_.push_back(statement.line);
  } else if (!sub) {
    return;
  }
  LabelUse& use = labels_.use(statement.label);
  std::uint32_t& place = sub ? use.sub : use.program;
  if (place == 0) {
    place = index;
    return;
  }
  const Statement& other = statements_[place];
  faults_.push_back(
      {statement.line, statement.label_at, sub ? &errors::kSubTwice : &errors::kProgramTwice,
       joined({shown_label(labels_.name(statement.label)), " is defined twice, first in line ",
               std::to_string(number_of(other.line))})});
}

std::uint32_t ProgramText::structure_around(std::uint32_t line) const {
  const auto behind = std::upper_bound(
      statements_.begin() + 1, statements_.end(), line,
      [](std::uint32_t wanted, const Statement& statement) { return wanted < statement.line; });
  const auto before = behind - 1;
  if (before == statements_.begin()) {
    return 0;
  }
  const bool opens =
      before->keyword == Keyword::macro_while || before->keyword == Keyword::macro_do;
  return opens ? static_cast<std::uint32_t>(before - statements_.begin()) : before->around;
}

void ProgramText::close() {
  if (!closed_) {
    closed_ = true;
    structure_.finish(faults_);
  }
}

ProgramText::Range ProgramText::program_around(std::uint32_t line) const {
  const auto next = std::upper_bound(programs_.begin(), programs_.end(), line);
  return {next == programs_.begin() ? 0 : *(next - 1), next == programs_.end() ? size() : *next};
}

std::size_t ProgramText::held_bytes() const {
  return store_.held_bytes() + statements_.capacity() * sizeof(Statement);
}

std::vector<StatementFault> ProgramText::take_faults() {
  return std::exchange(faults_, {});
}

}  // namespace kerf::parser
