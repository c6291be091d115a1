// One line of a program: its words, its calls, and what it makes the tool do.
#include <algorithm>
#include <string>
#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/block/block_grammar.hpp"
#include "parser/flow/block_calls.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/flow/statement_text.hpp"
#include "parser/reader/active_comments.hpp"
#include "parser/reader/block_warnings.hpp"
#include "parser/reader/program_run.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

// O1234 at the head of the program. True: the block is done with.
bool ProgramRun::is_program_number(const BlockWords& block, std::uint32_t line) {
  if (!block.has('O')) {
    return false;
  }
  const bool alone =
      (block.present & ~letter_bit('N')) == letter_bit('O') && block.g_count + block.m_count == 0;
  const double number = block.value('O');
  if (any_block_ || !alone || number < 0.0 || number > 99'999'999.0 ||
      number != static_cast<double>(static_cast<long>(number))) {
    diagnostics_.add({line, block.word('O').offset + 1}, errors::kOWordNotFirst,
                     "an o-word must be the first word of a block");
  }
  return true;
}

void ProgramRun::call(const NumberedLine& line, Call call) {
  if (!flow_.active()) {
    flow_.start(line, {.has_run = true});
  }
  flow_.call(std::move(call));
}

// M98 P100 L2, M99 P10, with whatever else the block says done before.
void ProgramRun::run_program_call(const NumberedLine& line, const Word& code) {
  if (code.value == 99.0) {
    const auto back = read_m99(block_, code);
    if (!back) {
      return report(line, *back.error());
    }
    run_without_call(line, code);
    return return_from_call(line, *back);
  }
  auto called = read_program_call(block_, code, options_.dialect, program_name_);
  if (!called) {
    return report(line, *called.error());
  }
  run_without_call(line, code);
  call(line, std::move(*called));
}

void ProgramRun::run_without_call(const NumberedLine& line, const Word& code) {
  remove_call(block_, code);
  if ((block_.present & ~letter_bit('N')) != 0 || block_.g_count + block_.m_count > 0) {
    interpret(line, true);
  }
}

void ProgramRun::report(const NumberedLine& line, const diagnostics::Fault& fault) {
  diagnostics_.add({line.number, fault.offset + 1}, *fault.page, fault.message);
}

void ProgramRun::return_from_call(const NumberedLine& line, const Return& back) {
  if (flow_.active() && flow_.return_from_call(back)) {
    return;
  }
  diagnostics_.add({line.number, back.offset + 1}, errors::kM99InMain,
                   "M99 in the main program: it would repeat without end and is ended here");
  interpreter_.end(line.number, "at M99");
  interpreter_.end_program({line.number, back.offset + 1});
}

// G65 calls once; G66 calls after each block that moves, until G67.
void ProgramRun::run_macro_call(const NumberedLine& line, const Word& code) {
  if (code.value == 67.0) {
    modal_calls_.cancel();
    return;
  }
  auto called = read_macro_call(line.text, evaluator_, program_name_);
  if (!called) {
    report(line, *called.error());
  } else if (code.value == 65.0) {
    call(line, std::move(*called));
  } else if (!modal_calls_.add(std::move(*called))) {
    diagnostics_.add({line.number, code.offset + 1}, errors::kTooManyModalCalls,
                     joined({"at most ", std::to_string(ModalCalls::kMax),
                             " modal calls (G66) may be in force: cancel with G67"}));
  }
}

// True: the block is done with.
bool ProgramRun::run_call(const NumberedLine& line, bool complete) {
  if (rules_.macro_calls) {
    if (const Word* const code = find_macro_code(block_)) {
      run_macro_call(line, *code);
      return true;
    }
  }
  const Word* const code = find_program_code(block_, options_.dialect);
  if (code != nullptr && complete) {
    run_program_call(line, *code);
  } else if (code != nullptr) {
    remove_call(block_, *code);
    interpret(line, false);  // says what is wrong after it
  }
  return code != nullptr;
}

void ProgramRun::read_line(const NumberedLine& line) {
  if (line.too_long) {
    diagnostics_.add({line.number, static_cast<std::uint32_t>(LineSplitter::kMaxLine) + 1},
                     errors::kLineTooLong,
                     joined({"the line is longer than the limit of ",
                             std::to_string(LineSplitter::kMaxLine), " bytes"}));
    any_block_ = true;
    return;
  }
  const std::size_t at = skip_blanks(line.text, 0);
  if (at == line.text.size()) {
    return;
  }
  if (line.left_out || (line.text[at] == '%' && read_percent(line, at))) {
    return;
  }
  if (options_.watcher != nullptr) {
    flow_.watch(line);
  }
  read_code(line);
  if (rules_.blocks_behind_semicolon && block_.remark != 0) {
    read_behind_semicolon(line);
  }
}

void ProgramRun::read_code(const NumberedLine& line) {
  called_ = false;
  const bool complete = read_block(line.text, block_, evaluator_);
  if (!complete && rules_.macro_calls && has_program_name()) {
    run_named_call(line);
  } else {
    run_block(line, complete);
  }
}

// As LinuxCNC has it, of a block's comments only the last one says anything, and it comes before
// the words. True: it ends the program.
bool ProgramRun::act_on_comment(const NumberedLine& line) {
  if (!rules_.active_comments || block_.comment == 0) {
    return false;
  }
  const auto comment = active_comment(line.text.substr(block_.comment));
  if (!comment) {
    return false;
  }
  if (comment->kind) {
    any_block_ = any_block_ || options_.one_line;
    if (options_.keeps_messages && messages_.size() < kMaxMessages) {
      messages_.push_back(
          {.block = interpreter_.blocks_run() + 1,
           .message = {.kind = *comment->kind,
                       .line = interpreter_.in_file({.line = line.number}).program_line(),
                       .text = message_text(*comment, parameters_)}});
    }
    return false;
  }
  diagnostics_.add({line.number, block_.comment}, errors::kAborted,
                   joined({"the program aborts itself: ", comment->text}));
  ended_ = rest_reported_ = true;
  return true;
}

void ProgramRun::run_block(const NumberedLine& line, bool complete) {
  if (complete && act_on_comment(line)) {
    return;
  }
  if (const auto unset = evaluator_.take_unset_read()) {
    warn_of_unset(*unset, line.number, diagnostics_);
  }
  if (block_.remarkable) {
    warn_about(block_, {line.number, options_.dialect}, said_, diagnostics_);
  }
  if (block_.assignment != 0) {
    any_block_ = true;
    if (complete && rules_.control_variables) {
      return act_on_signal(line);
    }
  }
  if (complete && block_.empty()) {
    return;
  }
  if (is_program_number(block_, line.number)) {
    return;
  }
  any_block_ = true;
  called_ = block_.g_count + block_.m_count > 0 && run_call(line, complete);
  if (called_) {
    return;
  }
  if (rules_.macro_calls) {
    return run_fanuc_block(line, complete);
  }
  interpreter_.run(block_, line.number, complete);
}

}  // namespace kerf::parser
