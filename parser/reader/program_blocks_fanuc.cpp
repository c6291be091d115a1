// Lines of the Fanuc dialect: calls by name, ';' as end of block, alarms, modal calls.
#include <string>

#include "diagnostics/errors/pages.hpp"
#include "parser/block/block_grammar.hpp"
#include "parser/dialects/fanuc/fanuc_codes.hpp"
#include "parser/flow/block_calls.hpp"
#include "parser/flow/statement_text.hpp"
#include "parser/reader/program_run.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

// M98 <NAME>, G65 <NAME> or G66 <NAME>, at which the grammar has stopped.
bool ProgramRun::has_program_name() const {
  const std::string_view text = block_.line;
  const std::size_t at = block_.stopped_at;
  if (block_.stop != Stop::none || at >= text.size() || text[at] != '<' ||
      behind_label(text, at) == at) {
    return false;
  }
  const Word* const code = find_program_code(block_, options_.dialect);
  return (code != nullptr && code->value == 98.0) || find_macro_code(block_) != nullptr;
}

// Keeps the name and reads the line again without it.
void ProgramRun::run_named_call(const NumberedLine& line) {
  const std::size_t at = block_.stopped_at;
  const std::size_t length = behind_label(line.text, at) - at;
  program_name_ = plain_label(line.text, {.label_at = static_cast<std::uint32_t>(at)});
  without_name_ = line.text;
  without_name_.replace(at, length, length, ' ');
  const NumberedLine rest{without_name_, line.number, line.too_long};
  run_block(rest, read_block(rest.text, block_, evaluator_));
  program_name_.clear();
}

// The blocks that follow in the line, each with blanks in place of those before it, so that columns
// stay what they are.
void ProgramRun::read_behind_semicolon(const NumberedLine& line) {
  NumberedLine rest = line;
  while (block_.remark != 0 && reads_as_block(rest.text.substr(block_.remark)) &&
         !interpreter_.program_ended()) {
    if (called_) {
      diagnostics_.add({line.number, block_.remark}, errors::kBlockBehindCall,
                       "a block after ';' cannot follow a call in the same line");
      return;
    }
    const std::size_t begin = block_.remark;
    diagnostics_.add({line.number, block_.remark}, errors::kSemicolonEndsBlock,
                     joined({"';' ends the block: ", quoted(rest.text.substr(begin)),
                             " is run as another one"}));
    std::string blocks(begin, ' ');
    blocks += rest.text.substr(begin);
    behind_semicolon_ = std::move(blocks);
    rest.text = behind_semicolon_;
    read_code(rest);
  }
}

// Where numbers count in units, that they do is said once, at the first cut; not of a program with
// curves of G6.2, whose knots without a point leave no doubt.
void ProgramRun::check_points(const NumberedLine& line) {
  const Motion motion = interpreter_.state().motion;
  const bool cuts = motion == Motion::line || motion == Motion::arc_clockwise ||
                    motion == Motion::arc_counterclockwise || is_cycle(motion);
  said_.no_point = said_.no_point || motion == Motion::nurbs;
  if (cuts && !said_.no_point && options_.machine.least_increment_mm == 0.0) {
    warn_of_missing_point(block_, interpreter_.state(), line.number, said_, diagnostics_);
  }
}

// Fanuc: #3000=n(TEXT) ends the program with an alarm, #3006=1(TEXT) stops it as M0 does.
void ProgramRun::act_on_signal(const NumberedLine& line) {
  const MacroSignal signal = interpreter_.take_signal();
  if (signal.kind == MacroSignal::Kind::stop) {
    read_block("M0", block_, evaluator_);
    interpreter_.run(block_, line.number, true);
  } else if (signal.kind == MacroSignal::Kind::alarm) {
    constexpr double kFirstAlarm = 3000.0;
    const std::uint32_t at = block_.assignment;
    const std::size_t open = line.text.find('(', at);
    const std::size_t close = line.text.find(')', at);
    const std::string_view text = close == std::string_view::npos || open > close
                                      ? ""
                                      : line.text.substr(open, close + 1 - open);
    diagnostics_.add({line.number, at}, errors::kMacroAlarm,
                     joined({"the program raises alarm ", shortest(kFirstAlarm + signal.number),
                             text.empty() ? "" : " ", text}));
    interpreter_.end(line.number, "at the alarm");
    interpreter_.end_program({line.number, at});
  }
}

void ProgramRun::interpret(const NumberedLine& line, bool complete) {
  const double least_increment_mm = options_.machine.least_increment_mm;
  if (rules_.least_increments && least_increment_mm != 0.0) {
    count_in_least_increments(interpreter_.state(), least_increment_mm, block_);
  }
  interpreter_.run(block_, line.number, complete);
}

void ProgramRun::run_fanuc_block(const NumberedLine& line, bool complete) {
  const bool idle = interpreter_.moves().empty();
  interpret(line, complete);
  if (complete && rules_.least_increments) {
    check_points(line);
  }
  if (modal_calls_.any() && idle && !interpreter_.moves().empty() &&
      block_.has_any(interpreter_.axis_letters())) {
    if (const Call* const modal = modal_calls_.begin(flow_.call_depth())) {
      call(line, *modal);
    }
  }
}

}  // namespace kerf::parser
