#include "parser/flow/statement_reader.hpp"

#include <algorithm>
#include <array>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/number.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

using detail::is_blank;
using detail::is_digit;

constexpr char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
}
constexpr bool is_letter(char c) {
  return static_cast<unsigned char>((c | 0x20) - 'a') < 26;
}

struct Word {
  std::string_view text;
  Keyword keyword;
};
constexpr std::array<Word, 16> kOWords{{{"sub", Keyword::o_sub},
                                        {"endsub", Keyword::o_endsub},
                                        {"return", Keyword::o_return},
                                        {"call", Keyword::o_call},
                                        {"if", Keyword::o_if},
                                        {"elseif", Keyword::o_elseif},
                                        {"else", Keyword::o_else},
                                        {"endif", Keyword::o_endif},
                                        {"while", Keyword::o_while},
                                        {"endwhile", Keyword::o_endwhile},
                                        {"do", Keyword::o_do},
                                        {"repeat", Keyword::o_repeat},
                                        {"endrepeat", Keyword::o_endrepeat},
                                        {"break", Keyword::o_break},
                                        {"continue", Keyword::o_continue},
                                        {"", Keyword::program}}};

diagnostics::Fault fault_at(std::size_t at, const diagnostics::ErrorPage& page,
                            std::string message) {
  return {static_cast<std::uint32_t>(at), std::move(message), &page};
}

void refuse(Statement& statement, diagnostics::Fault& fault, diagnostics::Fault found) {
  fault = std::move(found);
  statement.keyword = Keyword::wrong;
}

// Letters from `at` on, blanks between them left out, as RS274/NGC reads them.
std::string keyword_text(std::string_view line, std::size_t& at) {
  constexpr std::size_t kLongest = 24;
  std::string text;
  std::size_t end = at;
  for (std::size_t i = at; i < line.size() && text.size() < kLongest; ++i) {
    if (is_letter(line[i])) {
      text += lower(line[i]);
      end = i + 1;
    } else if (!is_blank(line[i])) {
      break;
    }
  }
  at = end;
  return text;
}

void read_o_word(std::string_view line, std::size_t at, Dialect dialect, Statement& statement,
                 diagnostics::Fault& fault) {
  const std::size_t label = skip_blanks(line, at + 1);
  const std::size_t label_end = behind_label(line, label);
  statement.label_at = static_cast<std::uint32_t>(label);
  if (label_end == label) {
    refuse(statement, fault,
           fault_at(at, errors::kNoLabel,
                    "a number, a <name> or an [expression] is expected after "
                    "'O'"));
    return;
  }
  statement.computed_label = line[label] == '[';
  std::size_t end = skip_blanks(line, label_end);
  statement.keyword_at = static_cast<std::uint32_t>(end);
  const std::string text = keyword_text(line, end);
  statement.rest = static_cast<std::uint32_t>(end);
  const std::string name = shown_label(plain_label(line, statement));
  const auto* const word = std::find_if(kOWords.begin(), kOWords.end(),
                                        [&](const Word& known) { return known.text == text; });
  if (word == kOWords.end()) {
    refuse(statement, fault,
           fault_at(statement.keyword_at, errors::kUnknownOWord,
                    joined({name, ": '", text, "' is not known (sub, call, if, while ...)"})));
    return;
  }
  statement.keyword = word->keyword;
  const bool program = word->keyword == Keyword::program;
  if (rules_of(dialect).macro_b && !program) {
    refuse(statement, fault,
           fault_at(at, errors::kOWordInFanuc,
                    joined({name, " ", text,
                            ": o-words belong to RS274/NGC, not to the Fanuc "
                            "dialect"})));
  } else if (statement.computed_label && word->keyword == Keyword::o_sub) {
    refuse(statement, fault,
           fault_at(label, errors::kComputedSub,
                    "a sub needs a number or a name, not an "
                    "expression"));
  } else if (program && (statement.computed_label || !only_comment_left(line, statement.rest))) {
    refuse(statement, fault,
           fault_at(statement.rest, errors::kUnknownOWord,
                    joined({name, ": sub, call, if, while ... is expected, found ",
                            quoted(line.substr(statement.rest))})));
  }
}

// Behind THEN stands an assignment, GOTO or a block, in the same line.
void check_then(std::string_view line, std::size_t behind, Statement& statement,
                diagnostics::Fault& fault) {
  if (only_comment_left(line, behind)) {
    refuse(
        statement, fault,
        fault_at(behind, errors::kThenForm, "THEN needs a statement behind it in the same line"));
    return;
  }
  const std::size_t at = skip_blanks(line, behind);
  for (const std::string_view keyword : {"IF", "WHILE", "DO", "END"}) {
    if (behind_keyword(line, at, keyword) != 0) {
      refuse(statement, fault,
             fault_at(at, errors::kThenForm,
                      joined({keyword, " cannot stand behind THEN: write GOTO"})));
    }
  }
}

// IF [..] GOTO, IF [..] THEN
void read_if(std::string_view line, std::size_t behind, Statement& statement,
             diagnostics::Fault& fault) {
  statement.keyword = Keyword::macro_if;
  const std::size_t open = skip_blanks(line, behind);
  statement.rest = static_cast<std::uint32_t>(open);
  const auto close = open < line.size() && line[open] == '[' ? behind_brackets(line, open)
                                                             : std::optional<std::size_t>{};
  if (!close) {
    refuse(statement, fault,
           fault_at(open, errors::kNoCondition, "IF: a condition in [ ] is expected"));
    return;
  }
  const std::size_t then = skip_blanks(line, *close);
  statement.keyword_at = static_cast<std::uint32_t>(then);
  if (behind_keyword(line, then, "goto") == 0 && behind_keyword(line, then, "then") == 0) {
    refuse(statement, fault,
           fault_at(then, errors::kNoThen, "THEN or GOTO is expected after IF [...]"));
  } else if (const std::size_t action = behind_keyword(line, then, "then"); action != 0) {
    check_then(line, action, statement, fault);
  }
}

// The number behind DO or END, 1 to 3.
void read_loop_number(std::string_view line, std::size_t at, std::string_view name,
                      Statement& statement, diagnostics::Fault& fault) {
  const std::size_t from = skip_blanks(line, at);
  std::size_t end = from;
  std::uint32_t number = 0;
  for (; end < line.size() && is_digit(line[end]) && number < 1000; ++end) {
    number = number * 10 + static_cast<std::uint32_t>(line[end] - '0');
  }
  statement.label = number;
  statement.rest = static_cast<std::uint32_t>(end);
  if (end == from || number < 1 || number > 3) {
    refuse(statement, fault,
           fault_at(from, errors::kLoopNumber,
                    joined({name, ": the loop's number must be 1, 2 or 3, found ",
                            end == from ? "none" : line.substr(from, end - from)})));
  } else if (!only_comment_left(line, end)) {
    refuse(statement, fault,
           fault_at(end, errors::kTextBehindStatement,
                    joined({"nothing may follow ", name, ", found ", quoted(line.substr(end))})));
  }
}

void read_while(std::string_view line, std::size_t behind, Statement& statement,
                diagnostics::Fault& fault) {
  statement.keyword = Keyword::macro_while;
  const std::size_t open = skip_blanks(line, behind);
  statement.keyword_at = static_cast<std::uint32_t>(open);
  const auto close = open < line.size() && line[open] == '[' ? behind_brackets(line, open)
                                                             : std::optional<std::size_t>{};
  if (!close) {
    refuse(statement, fault,
           fault_at(open, errors::kNoCondition, "WHILE: a condition in [ ] is expected"));
    return;
  }
  const std::size_t at = skip_blanks(line, *close);
  const std::size_t number = behind_keyword(line, at, "do");
  if (number == 0) {
    refuse(statement, fault,
           fault_at(at, errors::kNoDo,
                    "DO1, DO2 or DO3 is expected after "
                    "WHILE [...]"));
    return;
  }
  read_loop_number(line, number, "DO", statement, fault);
}

bool read_macro(std::string_view line, std::size_t at, Statement& statement,
                diagnostics::Fault& fault) {
  if (const std::size_t behind = behind_keyword(line, at, "if"); behind != 0) {
    read_if(line, behind, statement, fault);
  } else if (const std::size_t goto_ = behind_keyword(line, at, "goto"); goto_ != 0) {
    statement.keyword = Keyword::macro_goto;
    statement.rest = static_cast<std::uint32_t>(goto_);
    statement.keyword_at = static_cast<std::uint32_t>(at);
  } else if (const std::size_t while_ = behind_keyword(line, at, "while"); while_ != 0) {
    read_while(line, while_, statement, fault);
  } else if (const std::size_t do_ = behind_keyword(line, at, "do"); do_ != 0) {
    statement.keyword = Keyword::macro_do;
    read_loop_number(line, do_, "DO", statement, fault);
  } else if (behind_keyword(line, at, "else") != 0 || behind_keyword(line, at, "endif") != 0) {
    refuse(statement, fault,
           fault_at(at, errors::kThenForm,
                    "ELSE and ENDIF are not supported: write IF [..] GOTO around the blocks"));
  } else if (const std::size_t end = behind_keyword(line, at, "end"); end != 0) {
    statement.keyword = Keyword::macro_end;
    read_loop_number(line, end, "END", statement, fault);
  } else {
    return false;
  }
  return true;
}

}  // namespace

bool read_statement(std::string_view line, std::size_t at, Dialect dialect, Statement& statement,
                    diagnostics::Fault& fault) {
  const char first = at < line.size() ? lower(line[at]) : ' ';
  if (first == 'o' || (first == ':' && rules_of(dialect).macro_b)) {
    read_o_word(line, at, dialect, statement, fault);
    return true;
  }
  return rules_of(dialect).macro_b && read_macro(line, at, statement, fault);
}

}  // namespace kerf::parser
