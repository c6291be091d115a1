// Which line is next: runs the flow statements of a program and hands out its other lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic_list.hpp"
#include "parser/dialects/dialect.hpp"
#include "parser/expressions/evaluator.hpp"
#include "parser/flow/call.hpp"
#include "parser/flow/program_text.hpp"
#include "parser/flow/reader_options.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/program_input.hpp"

namespace kerf::parser {

// Text is taken in only as far as the flow needs it: line by line, and ahead of that only to find
// where a skipped structure ends, a subprogram or a jump's target. So the result is the same
// however the text is cut, and what is held is the text from start() on.
//
// The executor keeps no stack of structures: where each of them begins and ends is known from the
// text (Structure), the counters of repeat loops are numbered by their nesting, and only calls have
// frames. A loop therefore costs its own statements and nothing more. Weakness: conditions are
// worked out from their text anew each time.
class Flow {
 public:
  static constexpr std::size_t kMaxCalls = 32;
  // Fanuc: how much text is kept before it is known whether it has statements.
  static constexpr std::size_t kKeptText = std::size_t{4} << 20U;

  enum class Step : std::uint8_t {
    block,      // the line is to be run
    more_text,  // feed more
    plain,      // no longer active(): lines come straight from the input
    end,        // no line is next: the text has ended, or an error makes it impossible to go on
  };

  // All but the options must outlive the flow.
  Flow(const ReaderOptions& options, ProgramInput& input, Evaluator& evaluator,
       diagnostics::DiagnosticList& diagnostics, Interpreter& interpreter);

  // False: lines come straight from the input.
  [[nodiscard]] bool active() const { return active_; }
  // Whether a program in this dialect keeps its text from its first line on.
  [[nodiscard]] bool keeps_from_start() const {
    return rules_of(options_->dialect).macro_statements && !forgotten_;
  }
  // Keeps the text from this line on, which next() gives again unless it has been run already.
  // `keeping`: there is no statement yet, so the text may be dropped when it gets long.
  struct Start {
    bool has_run = false;
    bool keeping = false;
  };
  void start(const NumberedLine& line, Start how);
  // Precondition: active(). The line is valid until the next call.
  Step next(NumberedLine& line);
  // The line that next() gave made the tool move.
  void moved() {
    if (active_) {
      count_motion();
    }
  }

  // M98, M99 and G65 in the line that next() gave (or start() took), after its other words.
  void call(Call call);
  // False: there is nothing to return to, it is the main program.
  bool return_from_call(const Return& from);

  // The program has ended; the rest of its text is looked through for what closes a structure that
  // is open.
  void take_rest() {
    has_ended_ = true;
    while (grow()) {
    }
  }
  // Something of the text that is still to come can make it wrong.
  [[nodiscard]] bool needs_rest() const {
    return active_ && !failed_at_end_ && main_->structure_open() && !main_->closed();
  }
  // Whether what runs is wrong. Of what stands after the end that is said, too, but it is never
  // run and may come when nobody reads any more.
  [[nodiscard]] bool failed() const { return failed_at_end_.value_or(diagnostics_->has_errors()); }
  // Of a file as in SourcePosition; empty for 0.
  [[nodiscard]] std::string_view file_name(std::uint16_t file) const {
    return file == 0 ? std::string_view() : files_[file - 1U]->origin().file_name;
  }
  // Shows a line that is about to run, a statement or not, to the watcher, which there must be.
  void watch(const NumberedLine& line) const;
  [[nodiscard]] std::size_t call_depth() const { return frames_.size(); }
  [[nodiscard]] bool has_statements() const { return active_ && main_->has_statements(); }
  // As ProgramText has it, of the program itself.
  [[nodiscard]] std::uint32_t first_sub_line() const {
    return active_ ? main_->first_sub_line() : 0;
  }
  // A subprogram was called, ever.
  [[nodiscard]] bool has_called() const { return has_called_; }
  // Bytes of text and of what belongs to it.
  [[nodiscard]] std::size_t held_bytes() const { return active_ ? main_->held_bytes() : 0; }
  // An error or the next program's number ended the program.
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  enum class Goal : std::uint8_t {
    none,
    close,        // the close of the structure that `statement_` opens
    behind,       // the line after that
    next_clause,  // elseif, else or endif after the clause `statement_`
    call,         // the subprogram of `call_`
    target,       // the block with the number `target_`
  };
  struct Frame {
    CallKind kind = CallKind::sub;
    ProgramText* text = nullptr;  // the caller's
    std::uint32_t line = 0;       // to go on at
    std::uint32_t entry = 0;      // the subprogram's first line
    std::uint64_t runs = 0;       // that are still to come
    std::size_t counters = 0;     // of the caller in counters_
    std::size_t arguments = 0;    // in arguments_

    // The number of the call's line in `text`.
    [[nodiscard]] std::uint32_t calling_line() const {
      return text->number_of(line == 0 ? 0 : line - 1);
    }
  };
  struct Target {
    std::uint32_t number = 0;
    std::uint32_t from = 0;    // index of the jumping line
    std::uint32_t around = 0;  // structure around it
    std::uint32_t offset = 0;
    bool walked = false;  // over what there was when the search began
    std::optional<diagnostics::DiagnosticPlace> returned_by =
        std::nullopt;  // M99 P, in the text of the subprogram
  };
  struct Found {
    ProgramText* text = nullptr;  // nullptr: none
    std::uint32_t entry = 0;      // the subprogram's first line
  };

  // flow.cpp
  void forget();
  bool grow();
  void report_faults(ProgramText& text);
  void fault(std::uint32_t index, std::uint32_t offset, const diagnostics::ErrorPage& page,
             std::string message);
  void enter_text(ProgramText& text, std::uint32_t line);
  bool reach_goal();
  bool pass_goal();
  void jump(std::uint32_t line);
  void come_to(std::uint32_t line);
  void set_goal(Goal goal, std::uint32_t statement);
  void count_motion();
  void stop_endless_loop();
  Step at_end_of_text();
  bool take_line(NumberedLine& line);

  // flow_statements.cpp
  void run(std::uint32_t index);
  void watch();
  void run_o_word(std::uint32_t index, const Statement& statement);
  std::optional<double> read_value(std::size_t& at);
  std::optional<double> value_of(const Statement& statement);
  bool holds(const Statement& statement);
  bool expect_end(std::size_t at);
  void begin_repeat(std::uint32_t index, const Statement& statement);
  void end_repeat(const Statement& statement);
  void continue_loop(const Statement& statement);
  void try_clause(std::uint32_t index);
  void return_value(const Statement& statement);
  void call_sub(const Statement& statement);
  bool read_arguments(const Statement& statement);
  void meet_program_number(std::uint32_t index);

  // flow_calls.cpp
  bool find_and_enter();
  static Found find_in(ProgramText& text, const Call& call);
  Found find_in_file();
  Found find_local();
  ProgramText* load(const std::string& label);
  void enter(const Found& found);
  // Of the open calls the last one in the program itself; 0: none is.
  [[nodiscard]] std::uint32_t calling_line() const;
  void leave();
  void call_not_found();

  // flow_macros.cpp
  void run_macro(std::uint32_t index, const Statement& statement);
  void jump_if(const Statement& statement);
  void go_to(const Statement& statement, std::size_t at);
  const SequenceNumber* find_number();
  bool find_target();
  void target_not_found();
  void wrong_target(const diagnostics::ErrorPage& page, std::string message);
  [[nodiscard]] bool may_enter(std::uint32_t structure) const;

  const ReaderOptions* options_;
  ProgramInput* input_;
  Evaluator* evaluator_;
  diagnostics::DiagnosticList* diagnostics_;
  Interpreter* interpreter_;

  std::unique_ptr<ProgramText> main_;
  std::vector<std::unique_ptr<ProgramText>> files_;
  std::map<std::string, ProgramText*, std::less<>> file_of_label_;    // nullptr: there is none
  std::map<std::string, SubprogramText, std::less<>> refused_files_;  // by label
  ProgramText* text_ = nullptr;                                       // that is being read
  std::uint32_t cursor_ = 0;                                          // its next line
  std::uint32_t current_ = 0;                                         // the line given last
  std::vector<Frame> frames_;
  std::vector<double> arguments_;        // of the macro calls that repeat
  std::vector<std::uint64_t> counters_;  // of repeat loops, for each call by nesting
  std::size_t first_counter_ = 0;        // of the running call

  Goal goal_ = Goal::none;
  std::uint32_t statement_ = 0;
  Call call_;
  Target target_;
  std::string scratch_;     // a line whose beginning is blanked out
  bool has_ready_ = false;  // it is to be handed out

  std::uint64_t idle_steps_ = 0;
  std::uint32_t furthest_ = 0;  // line of the program that has moved the tool
  bool moves_in_vain_ = false;
  ProgramText* loop_text_ = nullptr;  // of the last line jumped back to; nullptr: none
  std::uint32_t loop_line_ = 0;
  bool active_ = false;
  bool keeping_ = false;  // only because statements may come
  bool has_called_ = false;
  bool forgotten_ = false;               // text before what is held has been dropped
  bool has_ended_ = false;               // the program
  std::optional<bool> failed_at_end_{};  // nothing: what stands after that was not read
  bool stopped_ = false;
};

}  // namespace kerf::parser
