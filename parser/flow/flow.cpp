#include "parser/flow/flow.hpp"

#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/flow/statement_text.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

Flow::Flow(const ReaderOptions& options, ProgramInput& input, Evaluator& evaluator,
           diagnostics::DiagnosticList& diagnostics, Interpreter& interpreter)
    : options_(&options),
      input_(&input),
      evaluator_(&evaluator),
      diagnostics_(&diagnostics),
      interpreter_(&interpreter) {}

void Flow::start(const NumberedLine& line, Start how) {
  main_ = std::make_unique<ProgramText>(
      TextOrigin{.dialect = options_->dialect, .first_line = line.number});
  text_ = main_.get();
  main_->take(line);
  report_faults(*main_);
  cursor_ = how.has_run ? 1 : 0;
  current_ = 0;
  active_ = true;
  keeping_ = how.keeping;
}

// Fanuc: so much text without a statement that the rest may as well be plain.
void Flow::forget() {
  main_.reset();
  text_ = nullptr;
  active_ = keeping_ = false;
  forgotten_ = true;
}

void Flow::fault(std::uint32_t index, std::uint32_t offset, const diagnostics::ErrorPage& page,
                 std::string message) {
  diagnostics_->at_line(text_->number_of(index), text_->line(index).view());
  diagnostics_->add({text_->number_of(index), offset + 1}, page, std::move(message));
}

void Flow::report_faults(ProgramText& text) {
  if (!text.has_faults()) {
    return;
  }
  diagnostics_->enter_file(text.origin().file, text.origin().file_name);
  for (StatementFault& found : text.take_faults()) {
    diagnostics_->at_line(text.number_of(found.line), text.line(found.line).view());
    diagnostics_->add({text.number_of(found.line), found.offset + 1}, *found.page,
                      std::move(found.message));
  }
  diagnostics_->enter_file(text_->origin().file, text_->origin().file_name);
}

// Takes in one more line of the program. False: there is none (yet).
bool Flow::grow() {
  if (main_->closed()) {
    return false;
  }
  const bool matters = !has_ended_ || needs_rest();
  NumberedLine line;
  const bool more = input_->next(line);
  if (more) {
    line.left_out = is_left_out(line.text, options_->block_delete);
    main_->take(line);
  } else if (input_->finished()) {
    main_->close();
  }
  if (!matters && !failed_at_end_) {
    failed_at_end_ = diagnostics_->has_errors();
  }
  report_faults(*main_);
  return more;
}

void Flow::enter_text(ProgramText& text, std::uint32_t line) {
  if (&text != text_) {
    text_ = &text;
    diagnostics_->enter_file(text.origin().file, text.origin().file_name);
    interpreter_->enter_file({.file = text.origin().file, .calling_line = calling_line()});
  }
  cursor_ = line;
}

void Flow::jump(std::uint32_t line) {
  if (line <= current_) {
    loop_text_ = text_;
    loop_line_ = line;
  }
  cursor_ = line;
}

// The line is the next to run.
void Flow::come_to(std::uint32_t line) {
  current_ = line;
  cursor_ = line + 1;
  interpreter_->enter_line(text_->number_of(line));
}

void Flow::set_goal(Goal goal, std::uint32_t statement) {
  goal_ = goal;
  statement_ = statement;
}

// One try. False: more of the program's text is needed for it.
bool Flow::pass_goal() {
  const Statement& statement = text_->statement(statement_);
  switch (goal_) {
    case Goal::close:
    case Goal::behind:
      if (statement.close == 0) {
        return false;
      }
      jump(text_->statement(statement.close).line + (goal_ == Goal::behind ? 1 : 0));
      break;
    case Goal::next_clause:
      if (statement.next == 0) {
        return false;
      }
      goal_ = Goal::none;
      try_clause(statement.next);
      return true;
    case Goal::call:
      if (!find_and_enter()) {
        return false;
      }
      break;
    case Goal::target:
      if (!find_target()) {
        return false;
      }
      break;
    case Goal::none:
      return true;
  }
  goal_ = Goal::none;
  return true;
}

// False: feed more, or it cannot be reached and the flow has stopped or goes on after it.
bool Flow::reach_goal() {
  while (goal_ != Goal::none && !stopped_) {
    if (pass_goal() || grow()) {
      continue;
    }
    if (!main_->closed()) {
      return false;
    }
    if (pass_goal()) {
      continue;  // the text's end was what had to be known
    }
    if (goal_ == Goal::call) {
      call_not_found();
    } else if (goal_ == Goal::target) {
      target_not_found();
    } else {
      stopped_ = true;  // a structure without a close has been reported by now
    }
    goal_ = Goal::none;
  }
  return true;
}

// A program with an error will not run, so after one a loop has no motion to go on for: only lines
// that have not moved before count.
void Flow::count_motion() {
  const bool anew = text_ == main_.get() && current_ > furthest_;
  furthest_ = anew ? current_ : furthest_;
  moves_in_vain_ = diagnostics_->has_errors() && !anew;
  idle_steps_ = moves_in_vain_ ? idle_steps_ : 0;
}

void Flow::stop_endless_loop() {
  if (loop_text_ != nullptr) {
    enter_text(*loop_text_, loop_line_);
    current_ = loop_line_;
  }
  const StoredLine& line = text_->line(current_);
  const std::size_t at = line.view().find_first_not_of(" \t");
  fault(current_, at == std::string_view::npos ? 0 : static_cast<std::uint32_t>(at),
        errors::kEndlessLoop,
        joined({"the loop ran ", std::to_string(options_->max_idle_steps),
                moves_in_vain_ ? " lines after an error" : " lines without motion",
                ": it is taken to be endless"}));
  stopped_ = true;
}

// No line is next in this text. Step::block: go on, there may be one now.
Flow::Step Flow::at_end_of_text() {
  if (keeping_ && main_->text_bytes() > kKeptText) {
    forget();
    return Step::plain;
  }
  if (text_ == main_.get() && grow()) {
    return Step::block;
  }
  if (text_ == main_.get() && !main_->closed()) {
    return Step::more_text;
  }
  if (frames_.empty() || stopped_) {
    return Step::end;
  }
  if (frames_.back().kind != CallKind::sub) {
    fault(text_->size() - 1, 0, errors::kNoM99,
          "the subprogram has no M99 before the end of the text");
  }
  stopped_ = text_ == main_.get();
  if (!stopped_) {
    leave();
  }
  return stopped_ ? Step::end : Step::block;
}

// Runs the line at the cursor where it is a statement. True: `line` is to be handed out.
bool Flow::take_line(NumberedLine& line) {
  const StoredLine& stored = text_->line(cursor_);
  come_to(cursor_);
  if (++idle_steps_ > options_->max_idle_steps) {
    stop_endless_loop();
    return false;
  }
  if (stored.statement == 0) {
    line = {.text = stored.view(),
            .number = text_->number_of(current_),
            .too_long = stored.too_long != 0,
            .left_out = stored.left_out != 0};
    return true;
  }
  run(stored.statement);
  if (has_ready_) {
    line = {.text = scratch_, .number = text_->number_of(current_)};
  }
  return std::exchange(has_ready_, false);
}

Flow::Step Flow::next(NumberedLine& line) {
  while (!stopped_) {
    if (goal_ != Goal::none) {
      if (!reach_goal()) {
        return Step::more_text;
      }
    } else if (cursor_ >= text_->size()) {
      if (const Step step = at_end_of_text(); step != Step::block) {
        return step;
      }
    } else if (take_line(line)) {
      return Step::block;
    }
  }
  return Step::end;
}

}  // namespace kerf::parser
