// The statements of custom macro B: IF, GOTO, WHILE and END.
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/flow/flow.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

void Flow::run_macro(std::uint32_t index, const Statement& statement) {
  switch (statement.keyword) {
    case Keyword::macro_if:
      return jump_if(statement);
    case Keyword::macro_goto:
      evaluator_->begin_line();
      return go_to(statement, statement.rest);
    case Keyword::macro_while: {
      evaluator_->begin_line();
      std::size_t at = statement.keyword_at;
      if (read_value(at).value_or(0.0) == 0.0) {
        set_goal(Goal::behind, index);
      }
      return;
    }
    case Keyword::macro_end:
      return jump(text_->statement(statement.head).line);
    default:
      return;  // DO; what was wrong
  }
}

// IF [..] GOTO n jumps; IF [..] THEN .. runs the rest of its line, which is handed out with the
// condition blanked out, so that columns stay what they are.
void Flow::jump_if(const Statement& statement) {
  evaluator_->begin_line();
  std::size_t at = statement.rest;
  if (read_value(at).value_or(0.0) == 0.0) {
    return;
  }
  const std::string_view line = text_->line(current_).view();
  if (const std::size_t target = behind_keyword(line, statement.keyword_at, "goto")) {
    return go_to(statement, target);
  }
  const std::size_t then = behind_keyword(line, statement.keyword_at, "then");
  if (const std::size_t target = behind_keyword(line, then, "goto")) {
    return go_to(statement, target);
  }
  scratch_.assign(then, ' ');
  scratch_ += line.substr(then);
  has_ready_ = true;
}

// The number after GOTO, at `at`.
void Flow::go_to(const Statement& statement, std::size_t at) {
  constexpr double kMax = 999'999'999.0;
  const std::string_view line = text_->line(current_).view();
  at = skip_blanks(line, at);
  const auto offset = static_cast<std::uint32_t>(at);
  const std::optional<double> number = read_value(at);
  if (!number || !expect_end(at)) {
    return;
  }
  if (!(*number >= 1.0 && *number <= kMax) || *number != std::floor(*number)) {
    fault(current_, offset, errors::kTargetNumber,
          joined({"GOTO: the sequence number must be a whole number from 1 to 999999999, found ",
                  shortest(*number)}));
    return;
  }
  target_ = {.number = static_cast<std::uint32_t>(*number),
             .from = current_,
             .around = statement.around,
             .offset = offset};
  set_goal(Goal::target, 0);
}

// Whether the structure that is opened by `structure` (0: none) is around the jump as well.
bool Flow::may_enter(std::uint32_t structure) const {
  std::uint32_t around = target_.around;
  while (around != 0 && around != structure) {
    around = text_->statement(around).around;
  }
  return around == structure;
}

// Forward to the end of the program first, then from its beginning, as the control searches.
const SequenceNumber* Flow::find_number() {
  SequenceNumbers& numbers = text_->sequence_numbers();
  const ProgramText::Range program = text_->program_around(target_.from);
  const bool whole = program.end < text_->size() || text_->closed();
  if (target_.walked && !whole && numbers.last() != target_.number) {
    return nullptr;
  }
  target_.walked = true;
  const SequenceNumber* found = nullptr;
  for (const SequenceNumber* one = numbers.first(target_.number);
       one != nullptr && one->line < program.end; one = numbers.behind(*one)) {
    if (one->line > target_.from) {
      found = one;
      break;
    }
    found = found == nullptr && whole && one->line >= program.begin ? one : found;
  }
  return found;
}

bool Flow::find_target() {
  const SequenceNumber* const found = find_number();
  if (found == nullptr) {
    return false;
  }
  if (!may_enter(found->around)) {
    wrong_target(errors::kJumpIntoLoop,
                 joined({"N", std::to_string(target_.number),
                         " stands inside a loop: a jump into it is not allowed"}));
    return true;
  }
  jump(found->line);
  return true;
}

void Flow::wrong_target(const diagnostics::ErrorPage& page, std::string message) {
  if (target_.returned_by) {
    diagnostics_->add_at(*target_.returned_by, page, std::move(message));
  } else {
    fault(target_.from, target_.offset, page, std::move(message));
  }
}

void Flow::target_not_found() {
  wrong_target(errors::kLabelMissing,
               joined({"N", std::to_string(target_.number), " is not found",
                       forgotten_ ? " in the text that was kept (only 4 MiB are kept before the "
                                    "first macro statement)"
                       : target_.returned_by ? " in the calling program"
                                             : " in this program"}));
}

}  // namespace kerf::parser
