// The order of a program's lines: its beginning, its end, and the flow between them.
#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/reader/program_run.hpp"

namespace kerf::parser {

namespace {

constexpr double kLoopMotion_rad_mm = 10.0 * kShortestWay_mm;

// A loop may go on for as long as it moves. What its steps add up to is no motion where each is
// too short to be one: such a loop would take days to come to a bound on moves.
bool is_motion(const Move& move) {
  return end_mm(move) != nullptr && (way_mm(move) >= kLoopMotion_rad_mm ||
                                     move.auxiliary.length_rad_mm() >= kLoopMotion_rad_mm);
}

}  // namespace

// '%' opens the program (a title may follow it) and closes it. True: the line is done with.
bool ProgramRun::read_percent(const NumberedLine& line, std::size_t at) {
  if (!opened_by_percent_ && !any_block_) {
    opened_by_percent_ = true;
    opening_line_ = line.number;
    return true;
  }
  const std::size_t rest = line.text.find_first_not_of(" \t", at + 1);
  if (rest != std::string_view::npos && line.text[rest] != '(' && line.text[rest] != ';') {
    diagnostics_.add({line.number, static_cast<std::uint32_t>(at) + 1}, errors::kPercentNotAlone,
                     "'%' must stand alone on its line");
    return true;
  }
  interpreter_.end(line.number, "at the closing %");
  interpreter_.end_program({line.number, static_cast<std::uint32_t>(at) + 1});
  closed_by_percent_ = true;
  return true;
}

// Text after the program's end is passed over; that it is there is said once.
void ProgramRun::read_rest(const NumberedLine& line) {
  const std::size_t at = skip_blanks(line.text, 0);
  const bool empty = at == line.text.size() || line.text[at] == '(' || line.text[at] == ';';
  if (rest_reported_ || empty || (line.text[at] == '%' && !closed_by_percent_)) {
    return;
  }
  rest_reported_ = true;
  diagnostics_.add({line.number, static_cast<std::uint32_t>(at) + 1},
                   closed_by_percent_ ? errors::kTextAfterPercent : errors::kBlocksAfterEnd,
                   closed_by_percent_ ? "text after the closing '%' is ignored"
                                      : "blocks after the program's end are never executed");
}

void ProgramRun::reach_end() {
  ended_ = true;
  diagnostics_.at_line(0, {});
  const std::uint32_t last = input_.lines();
  interpreter_.end(last, "at the end of the file");
  if (flow_.stopped()) {
    return;
  }
  if (!any_block_ && !flow_.has_statements()) {
    diagnostics_.add({1, 1}, errors::kEmptyProgram, "the program is empty");
  } else if (options_.one_line) {
    return;
  } else if (opened_by_percent_) {
    diagnostics_.add({opening_line_, 1}, errors::kUnclosedPercent,
                     "the file starts with '%' but has no closing '%'");
  } else {
    diagnostics_.add({last, 1}, errors::kNoProgramEnd,
                     "the program has no M2, M30 or '%' at its end");
  }
}

// Whether the text has to be kept from this line on.
bool ProgramRun::begins_flow(const NumberedLine& line) const {
  if (rules_.macro_statements && flow_.keeps_from_start()) {
    return true;
  }
  if (line.left_out) {
    return false;
  }
  const std::string_view text = line.text;
  std::size_t at = skip_blanks(text, 0);
  const char first = at == text.size() ? ' ' : text[at];
  if (first == 'N' || first == 'n' || first == '/') {
    at = find_block_start(text).at;
  }
  if (!may_be_statement(text, at, rules_)) {
    return false;
  }
  const auto statement = read_statement(text, at, options_.dialect);
  return !statement || (statement->keyword != Keyword::none &&
                        (statement->keyword != Keyword::program || any_block_));
}

bool ProgramRun::next_plain_line(NumberedLine& line) {
  if (input_.next(line)) {
    line.left_out = is_left_out(line.text, options_.block_delete);
    return true;
  }
  if (input_.refused()) {
    ended_ = rest_reported_ = true;
  } else if (input_.finished() && !ended_) {
    reach_end();
  }
  return false;
}

// The line to run or, once the program has ended, of the rest.
bool ProgramRun::next_line(NumberedLine& line) {
  while (!ended_) {
    if (!flow_.active()) {
      if (!next_plain_line(line)) {
        return false;
      }
      if (!begins_flow(line)) {
        return true;
      }
      flow_.start(line, {.keeping = flow_.keeps_from_start()});
      any_block_ = any_block_ || !flow_.keeps_from_start();
    }
    switch (flow_.next(line)) {
      case Flow::Step::block:
        return true;
      case Flow::Step::more_text:
        return false;
      case Flow::Step::plain:
        break;
      case Flow::Step::end:
        reach_end();
        break;
    }
  }
  if (flow_.active()) {
    flow_.take_rest();
  }
  return next_plain_line(line);
}

// Once, at its end.
void ProgramRun::report_idle_program() {
  const std::uint32_t line = flow_.first_sub_line();
  if (!does_anything_ && !flow_.has_called() && line > 0 && !diagnostics_.has_errors()) {
    diagnostics_.at_line(line, {});
    diagnostics_.add({line, 1}, errors::kOnlySubprograms,
                     "the program defines subprograms and calls none: nothing is run");
  }
  does_anything_ = true;
}

bool ProgramRun::next(Move& move) {
  messages_.clear();
  if (question_) {
    return false;
  }
  do {
    if (!next_move(move)) {
      if (ended_) {
        report_idle_program();
      }
      return false;
    }
    const auto* event = std::get_if<EventMove>(&move.shape);
    does_anything_ = does_anything_ || event == nullptr || event->kind != EventKind::program_end;
  } while (!short_moves_.take(move));
  if (is_motion(move)) {
    flow_.moved();
  } else if (const auto* event = std::get_if<EventMove>(&move.shape);
             event != nullptr && event->kind == EventKind::ask_machine) {
    question_ = event->question;
  }
  return true;
}

void ProgramRun::answer(const MachineAnswer& answer) {
  const MachineQuestion question = *std::exchange(question_, std::nullopt);
  if (is_probe(question)) {
    short_moves_.end_at(answer.rest_mm);
  }
  interpreter_.take_answer(question, answer);
}

bool ProgramRun::next_move(Move& move) {
  while (interpreter_.moves().empty()) {
    NumberedLine line;
    if (!next_line(line)) {
      if (interpreter_.moves().empty()) {
        return false;
      }
      break;  // the end of the text has let go what was held
    }
    diagnostics_.at_line(line.number, line.text);
    if (ended_) {
      read_rest(line);
      continue;
    }
    interpreter_.enter_line(line.number);
    read_line(line);
    if (diagnostics_.full()) {
      diagnostics_.add({line.number, 1}, errors::kTooManyErrors,
                       "too many errors: the rest is not read");
      ended_ = rest_reported_ = true;
    }
    ended_ = ended_ || interpreter_.program_ended();
    if (ended_) {
      input_.pass_over();
    }
  }
  interpreter_.moves().pop(move);
  all_fetched_ = interpreter_.moves().empty();
  return true;
}

}  // namespace kerf::parser
