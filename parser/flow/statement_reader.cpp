#include "parser/flow/statement_reader.hpp"

#include <algorithm>
#include <array>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/number.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

using diagnostics::Expected;

namespace {

using detail::is_blank;
using detail::is_digit;
using diagnostics::Done;
using diagnostics::fail;

struct OWord {
  std::string_view text;
  Keyword keyword;
};
constexpr std::array<OWord, 16> kOWords{{{"sub", Keyword::o_sub},
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

// Letters from `at` on, blanks between them left out, as RS274/NGC reads them.
std::string keyword_text(std::string_view line, std::size_t& at) {
  constexpr std::size_t kLongest = 24;
  std::string text;
  std::size_t end = at;
  for (std::size_t i = at; i < line.size() && text.size() < kLongest; ++i) {
    if (detail::is_letter(line[i])) {
      text += detail::lower(line[i]);
      end = i + 1;
    } else if (!is_blank(line[i])) {
      break;
    }
  }
  at = end;
  return text;
}

Expected<Statement> read_o_word(std::string_view line, std::size_t at, const DialectRules& rules) {
  const std::size_t label = skip_blanks(line, at + 1);
  const std::size_t label_end = behind_label(line, label);
  if (label_end == label) {
    return fail(at, errors::kNoLabel,
                "a number, a <name> or an [expression] is expected after 'O'");
  }
  Statement statement;
  statement.label_at = static_cast<std::uint32_t>(label);
  statement.computed_label = line[label] == '[';
  std::size_t end = skip_blanks(line, label_end);
  statement.keyword_at = static_cast<std::uint32_t>(end);
  const std::string text = keyword_text(line, end);
  statement.rest = static_cast<std::uint32_t>(end);
  const std::string name = shown_label(plain_label(line, statement));
  const auto* const word = std::find_if(kOWords.begin(), kOWords.end(),
                                        [&](const OWord& known) { return known.text == text; });
  if (word == kOWords.end()) {
    return fail(statement.keyword_at, errors::kUnknownOWord,
                joined({name, ": '", text, "' is not known (sub, call, if, while ...)"}));
  }
  statement.keyword = word->keyword;
  const bool program = word->keyword == Keyword::program;
  if (!rules.o_words && !program) {
    return fail(
        at, errors::kOWordInFanuc,
        joined({name, " ", text, ": o-words belong to RS274/NGC, not to the Fanuc dialect"}));
  }
  if (statement.computed_label && word->keyword == Keyword::o_sub) {
    return fail(label, errors::kComputedSub, "a sub needs a number or a name, not an expression");
  }
  if (program && (statement.computed_label || !only_comment_left(line, end))) {
    return fail(
        end, errors::kUnknownOWord,
        joined({name, ": sub, call, if, while ... is expected, found ", quoted(line.substr(end))}));
  }
  return statement;
}

// After THEN stands an assignment, GOTO or a block, in the same line.
Done check_then(std::string_view line, std::size_t behind) {
  if (only_comment_left(line, behind)) {
    return fail(behind, errors::kThenForm, "THEN needs a statement after it in the same line");
  }
  const std::size_t at = skip_blanks(line, behind);
  for (const std::string_view keyword : {"IF", "WHILE", "DO", "END"}) {
    if (behind_keyword(line, at, keyword) != 0) {
      return fail(at, errors::kThenForm, joined({keyword, " cannot stand after THEN: write GOTO"}));
    }
  }
  return {};
}

// Offset after the condition in brackets that begins at `at`.
Expected<std::size_t> behind_condition(std::string_view line, std::size_t at,
                                       std::string_view name) {
  const auto close = at < line.size() && line[at] == '[' ? behind_brackets(line, at) : std::nullopt;
  if (!close) {
    return fail(at, errors::kNoCondition, joined({name, ": a condition in [ ] is expected"}));
  }
  return skip_blanks(line, *close);
}

// IF [..] GOTO, IF [..] THEN
Expected<Statement> read_if(std::string_view line, std::size_t behind) {
  Statement statement{.keyword = Keyword::macro_if};
  const std::size_t open = skip_blanks(line, behind);
  statement.rest = static_cast<std::uint32_t>(open);
  Expected<std::size_t> then = behind_condition(line, open, "IF");
  if (!then) {
    return fault_of(then);
  }
  statement.keyword_at = static_cast<std::uint32_t>(*then);
  if (behind_keyword(line, *then, "goto") != 0) {
    return statement;
  }
  const std::size_t action = behind_keyword(line, *then, "then");
  if (action == 0) {
    return fail(*then, errors::kNoThen, "THEN or GOTO is expected after IF [...]");
  }
  return check_then(line, action).map([&] { return statement; });
}

// The number after DO or END, 1 to 3.
Expected<Statement> read_loop_number(std::string_view line, std::size_t at, std::string_view name,
                                     Statement statement) {
  const std::size_t from = skip_blanks(line, at);
  std::size_t end = from;
  std::uint32_t number = 0;
  for (; end < line.size() && is_digit(line[end]) && number < 1000; ++end) {
    number = number * 10 + static_cast<std::uint32_t>(line[end] - '0');
  }
  if (end == from || number < 1 || number > 3) {
    return fail(from, errors::kLoopNumber,
                joined({name, ": the loop's number must be 1, 2 or 3, found ",
                        end == from ? "none" : line.substr(from, end - from)}));
  }
  if (!only_comment_left(line, end)) {
    return fail(end, errors::kTextBehindStatement,
                joined({"nothing may follow ", name, ", found ", quoted(line.substr(end))}));
  }
  statement.label = number;
  statement.rest = static_cast<std::uint32_t>(end);
  return statement;
}

Expected<Statement> read_while(std::string_view line, std::size_t behind) {
  const std::size_t open = skip_blanks(line, behind);
  Expected<std::size_t> at = behind_condition(line, open, "WHILE");
  if (!at) {
    return fault_of(at);
  }
  const std::size_t number = behind_keyword(line, *at, "do");
  if (number == 0) {
    return fail(*at, errors::kNoDo, "DO1, DO2 or DO3 is expected after WHILE [...]");
  }
  return read_loop_number(
      line, number, "DO",
      {.keyword = Keyword::macro_while, .keyword_at = static_cast<std::uint32_t>(open)});
}

Expected<Statement> read_macro(std::string_view line, std::size_t at) {
  Statement statement{.keyword_at = static_cast<std::uint32_t>(at)};
  if (const std::size_t behind = behind_keyword(line, at, "if"); behind != 0) {
    return read_if(line, behind);
  }
  if (const std::size_t behind = behind_keyword(line, at, "goto"); behind != 0) {
    statement.keyword = Keyword::macro_goto;
    statement.rest = static_cast<std::uint32_t>(behind);
    return statement;
  }
  if (const std::size_t behind = behind_keyword(line, at, "while"); behind != 0) {
    return read_while(line, behind);
  }
  if (const std::size_t behind = behind_keyword(line, at, "do"); behind != 0) {
    statement.keyword = Keyword::macro_do;
    return read_loop_number(line, behind, "DO", statement);
  }
  if (behind_keyword(line, at, "else") != 0 || behind_keyword(line, at, "endif") != 0) {
    return fail(at, errors::kThenForm,
                "ELSE and ENDIF are not supported: write IF [..] GOTO around the blocks");
  }
  if (const std::size_t behind = behind_keyword(line, at, "end"); behind != 0) {
    statement.keyword = Keyword::macro_end;
    return read_loop_number(line, behind, "END", statement);
  }
  return statement;
}

}  // namespace

Expected<Statement> read_statement(std::string_view line, std::size_t at, Dialect dialect) {
  const DialectRules& rules = rules_of(dialect);
  const char first = at < line.size() ? detail::lower(line[at]) : ' ';
  if (first == 'o' || (first == ':' && rules.numbered_programs)) {
    return read_o_word(line, at, rules);
  }
  return rules.macro_statements ? read_macro(line, at) : Statement{};
}

std::string_view name_of(Keyword keyword) {
  const Keyword written = keyword == Keyword::o_do_while ? Keyword::o_while : keyword;
  const auto* const word =
      std::find_if(kOWords.begin(), kOWords.end(),
                   [written](const OWord& known) { return known.keyword == written; });
  return word == kOWords.end() ? std::string_view() : word->text;
}

}  // namespace kerf::parser
