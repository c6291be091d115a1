// O-words, each run by the places that its structure has in the text.
#include <algorithm>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/expressions/evaluator.hpp"
#include "parser/flow/flow.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

void Flow::watch() {
  if (options_->watcher != nullptr) {
    watch({text_->line(current_).view(), text_->number_of(current_)});
  }
}

void Flow::watch(const NumberedLine& line) const {
  UpcomingBlock block{.text = line.text,
                      .source = interpreter_->in_file({.line = line.number, .column = 1}),
                      .state = interpreter_->state(),
                      .blocks_before = interpreter_->blocks_run(),
                      .in_curve = interpreter_->in_curve()};
  for (const Frame& frame : frames_) {
    block.calls.push_back(frame.calling_line());
  }
  options_->watcher->about_to_run(block);
}

void Flow::run(std::uint32_t index) {
  watch();
  const Statement& statement = text_->statement(index);
  keeping_ = keeping_ && statement.keyword == Keyword::program;
  if (statement.keyword == Keyword::program) {
    meet_program_number(index);
  } else if (statement.keyword >= Keyword::macro_if) {
    run_macro(index, statement);
  } else {
    run_o_word(index, statement);
  }
}

void Flow::run_o_word(std::uint32_t index, const Statement& statement) {
  switch (statement.keyword) {
    case Keyword::o_sub:
      return set_goal(Goal::behind, index);
    case Keyword::o_endsub:
    case Keyword::o_return:
      return return_value(statement);
    case Keyword::o_call:
      return call_sub(statement);
    case Keyword::o_if:
      return holds(statement) ? void() : set_goal(Goal::next_clause, index);
    // Reached from above: another branch has run.
    case Keyword::o_elseif:
    case Keyword::o_else:
      return set_goal(Goal::behind, statement.head);
    case Keyword::o_while:
      return holds(statement) ? void() : set_goal(Goal::behind, index);
    case Keyword::o_endwhile:
      return jump(text_->statement(statement.head).line);
    case Keyword::o_do_while:
      return holds(statement) ? jump(text_->statement(statement.head).line + 1) : void();
    case Keyword::o_repeat:
      return begin_repeat(index, statement);
    case Keyword::o_endrepeat:
      return end_repeat(statement);
    case Keyword::o_break:
      return set_goal(Goal::behind, statement.head);
    case Keyword::o_continue:
      return continue_loop(statement);
    default:
      return;  // endif, do
  }
}

// A value of the line that is being run, in brackets, at `at`, which moves after it. None: it is
// wrong and has been reported.
std::optional<double> Flow::read_value(std::size_t& at) {
  const std::string_view line = text_->line(current_).view();
  Cursor cursor{line, at};
  double value = 0.0;
  if (!evaluator_->read_value(cursor, value)) {
    const diagnostics::Fault& found = evaluator_->fault();
    fault(current_, found.offset, *found.page, found.message);
    return std::nullopt;
  }
  at = cursor.at;
  if (const auto unset = evaluator_->take_unset_read()) {
    diagnostics_->at_line(text_->number_of(current_), line);
    warn_of_unset(*unset, text_->number_of(current_), *diagnostics_);
  }
  return is_vacant(value) ? 0.0 : value;
}

bool Flow::expect_end(std::size_t at) {
  const std::string_view line = text_->line(current_).view();
  if (only_comment_left(line, at)) {
    return true;
  }
  at = skip_blanks(line, at);
  fault(current_, static_cast<std::uint32_t>(at), errors::kTextBehindStatement,
        joined({"only a comment may follow here, found ", quoted(line.substr(at))}));
  return false;
}

// The one value that follows the statement's keyword.
std::optional<double> Flow::value_of(const Statement& statement) {
  const std::string_view line = text_->line(current_).view();
  std::size_t at = skip_blanks(line, statement.rest);
  if (at >= line.size() || line[at] != '[') {
    fault(current_, static_cast<std::uint32_t>(at), errors::kNoCondition,
          joined({quoted(line.substr(statement.keyword_at, at - statement.keyword_at)),
                  " needs a value in [ ]"}));
    return std::nullopt;
  }
  evaluator_->begin_line();
  const std::optional<double> value = read_value(at);
  return value && expect_end(at) ? value : std::nullopt;
}

bool Flow::holds(const Statement& statement) {
  return value_of(statement).value_or(0.0) != 0.0;
}

void Flow::try_clause(std::uint32_t index) {
  const Statement& clause = text_->statement(index);
  come_to(clause.line);
  watch();
  if (clause.keyword == Keyword::o_elseif && !holds(clause)) {
    set_goal(Goal::next_clause, index);
  }
}

void Flow::begin_repeat(std::uint32_t index, const Statement& statement) {
  constexpr double kMax = 1e15;
  const std::optional<double> count = value_of(statement);
  if (!count) {
    return set_goal(Goal::behind, index);
  }
  const double whole = std::round(*count);
  if (whole < 0.0) {
    fault(current_, statement.keyword_at, errors::kNegativeCount,
          joined({"the repeat count is negative (", shortest(whole), "): nothing is repeated"}));
  }
  if (whole < 1.0) {
    return set_goal(Goal::behind, index);
  }
  const std::size_t place = first_counter_ + statement.repeats;
  if (counters_.size() <= place) {
    counters_.resize(place + 1);
  }
  counters_[place] = static_cast<std::uint64_t>(std::min(whole, kMax));
}

void Flow::end_repeat(const Statement& statement) {
  const std::size_t place = first_counter_ + statement.repeats;
  if (place < counters_.size() && counters_[place] > 1) {
    --counters_[place];
    jump(text_->statement(statement.head).line + 1);
  }
}

// On to where the loop decides whether it goes on.
void Flow::continue_loop(const Statement& statement) {
  const Statement& loop = text_->statement(statement.head);
  if (loop.keyword == Keyword::o_while) {
    return jump(loop.line);
  }
  set_goal(Goal::close, statement.head);
}

// endsub and return: the value goes into #<_value>.
void Flow::return_value(const Statement& statement) {
  const std::string_view line = text_->line(current_).view();
  const std::size_t at = skip_blanks(line, statement.rest);
  std::optional<double> value;
  if (at < line.size() && line[at] == '[') {
    value = value_of(statement);
  } else {
    expect_end(at);
  }
  Parameters& parameters = evaluator_->parameters();
  parameters.set("_value", value.value_or(0.0));
  parameters.set("_value_returned", value ? 1.0 : 0.0);
  if (!frames_.empty()) {
    leave();
  }
}

bool Flow::read_arguments(const Statement& statement) {
  constexpr std::size_t kMax = 30;
  const std::string_view line = text_->line(current_).view();
  std::size_t at = skip_blanks(line, statement.rest);
  call_.arguments = 0;
  while (at < line.size() && line[at] == '[') {
    if (call_.arguments == kMax) {
      fault(current_, static_cast<std::uint32_t>(at), errors::kTooManyArguments,
            joined({"a call takes at most ", std::to_string(kMax), " arguments"}));
      return false;
    }
    const std::optional<double> value = read_value(at);
    if (!value) {
      return false;
    }
    call_.values[call_.arguments++] = *value;
    at = skip_blanks(line, at);
  }
  return expect_end(at);
}

void Flow::call_sub(const Statement& statement) {
  evaluator_->begin_line();
  if (statement.computed_label) {
    std::size_t at = statement.label_at;
    const std::optional<double> number = read_value(at);
    if (!number) {
      return;
    }
    const double whole = std::round(*number);
    if (std::fabs(*number - whole) > kWholeTolerance || whole < 0.0) {
      return fault(current_, statement.label_at, errors::kNoLabel,
                   joined({"the label must be a whole number, found ", shortest(*number)}));
    }
    call_.label = shortest(whole);
  } else {
    call_.label = text_->labels().name(statement.label);
  }
  call_.kind = CallKind::sub;
  call_.runs = 1;
  call_.line = current_;
  call_.offset = statement.keyword_at;
  if (read_arguments(statement)) {
    set_goal(Goal::call, 0);
  }
}

// The flow runs into O1234. RS274/NGC goes on; on a Fanuc control the program ends before it.
void Flow::meet_program_number(std::uint32_t index) {
  if (!frames_.empty() && frames_.back().kind != CallKind::sub) {
    fault(current_, text_->statement(index).label_at, errors::kNoM99,
          "the subprogram before this one has no M99");
    return leave();
  }
  if (frames_.empty() && rules_of(options_->dialect).numbered_programs && !text_->is_head(index)) {
    fault(current_, text_->statement(index).label_at, errors::kRunsIntoProgram,
          "the program ends here, it has no M30, M2 or M99");
    stopped_ = true;
  }
}

}  // namespace kerf::parser
