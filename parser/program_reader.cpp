#include "parser/program_reader.hpp"

#include <optional>
#include <utility>

#include "parser/block_grammar.hpp"
#include "parser/block_warnings.hpp"
#include "parser/errors/characters.hpp"
#include "parser/errors/fanuc.hpp"
#include "parser/errors/files.hpp"
#include "parser/errors/flow.hpp"
#include "parser/errors/macros.hpp"
#include "parser/errors/subprograms.hpp"
#include "parser/errors/words.hpp"
#include "parser/expressions/evaluator.hpp"
#include "parser/expressions/parameters.hpp"
#include "parser/fanuc/end_of_block.hpp"
#include "parser/flow/block_calls.hpp"
#include "parser/flow/flow.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/interpreter.hpp"
#include "parser/program_input.hpp"
#include "parser/text.hpp"

namespace kerf::parser {

namespace {

constexpr std::string_view kBlanks = " \t";

std::size_t first_visible(std::string_view text) {
  return text.find_first_not_of(kBlanks);
}

}  // namespace

class ProgramReader::Impl {
 public:
  explicit Impl(const ReaderOptions& options)
      : options_(options),
        diagnostics_(options.max_errors),
        input_(diagnostics_),
        interpreter_(options.start_mm, diagnostics_, options.machine, options.dialect),
        parameters_(options.dialect),
        evaluator_(parameters_),
        flow_(options_, input_, evaluator_, diagnostics_, interpreter_) {
    parameters_.use(interpreter_.values());
  }

  ProgramInput& input() { return input_; }
  bool next(Move& move);
  [[nodiscard]] bool at_end() const { return ended_ && all_fetched_ && !flow_.needs_rest(); }
  [[nodiscard]] const DiagnosticList& diagnostics() const { return diagnostics_; }
  [[nodiscard]] const std::optional<WatchedBlock>& watched_block() const { return watched_block_; }
  [[nodiscard]] std::size_t held_bytes() const { return flow_.held_bytes(); }
  [[nodiscard]] std::string_view file_name(std::uint16_t file) const {
    return flow_.file_name(file);
  }

 private:
  bool next_line(Line& line);
  bool next_plain_line(Line& line);
  bool begins_flow(std::string_view text) const;
  void read_line(const Line& line);
  void read_code(const Line& line);
  void read_behind_semicolon(const Line& line);
  bool read_percent(const Line& line, std::size_t at);
  void read_rest(const Line& line);
  bool is_program_number(const Block& block, std::uint32_t line);
  bool run_call(const Line& line, bool complete);
  void run_program_call(const Line& line, const Word& code);
  void run_macro_call(const Line& line, const Word& code);
  void call(const Line& line, Call call);
  void return_from_call(const Line& line, const Return& back);
  void run_block(const Line& line, bool complete);
  void reach_end();

  ReaderOptions options_;
  DiagnosticList diagnostics_;
  ProgramInput input_;
  Interpreter interpreter_;
  Parameters parameters_;
  Evaluator evaluator_;
  Flow flow_;
  Block block_;
  bool called_ = false;             // the block is a call or a return
  std::string behind_semicolon_;    // the rest of a Fanuc line with more than one block
  std::optional<Call> modal_call_;  // G66
  std::size_t modal_depth_ = 0;     // of the calls where it was given
  bool ended_ = false;              // the program, not the bytes
  bool all_fetched_ = true;         // all its moves are fetched
  bool any_block_ = false;
  bool opened_by_percent_ = false;
  bool closed_by_percent_ = false;
  bool rest_reported_ = false;
  std::uint32_t opening_line_ = 0;
  std::optional<WatchedBlock> watched_block_;
};

// '%' opens the program (a title may follow it) and closes it. True: the line is done with.
bool ProgramReader::Impl::read_percent(const Line& line, std::size_t at) {
  if (!opened_by_percent_ && !any_block_) {
    opened_by_percent_ = true;
    opening_line_ = line.number;
    return true;
  }
  const std::size_t rest = line.text.find_first_not_of(kBlanks, at + 1);
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

// Text behind the program's end is passed over; that it is there is said once.
void ProgramReader::Impl::read_rest(const Line& line) {
  const std::size_t at = first_visible(line.text);
  const bool empty = at == std::string_view::npos || line.text[at] == '(' || line.text[at] == ';';
  if (rest_reported_ || empty || (line.text[at] == '%' && !closed_by_percent_)) {
    return;
  }
  rest_reported_ = true;
  diagnostics_.add({line.number, static_cast<std::uint32_t>(at) + 1},
                   closed_by_percent_ ? errors::kTextAfterPercent : errors::kBlocksAfterEnd,
                   closed_by_percent_ ? "text after the closing '%' is ignored"
                                      : "blocks after the program's end are never executed");
}

// O1234 at the head of the program. True: the block is done with.
bool ProgramReader::Impl::is_program_number(const Block& block, std::uint32_t line) {
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

void ProgramReader::Impl::run_block(const Line& line, bool complete) {
  interpreter_.run(block_, line.number, complete);
}

void ProgramReader::Impl::call(const Line& line, Call call) {
  if (!flow_.active()) {
    flow_.start(line, {.has_run = true});
  }
  flow_.call(std::move(call));
}

// M98 P100 L2, M99 P10, with whatever else the block says done before.
void ProgramReader::Impl::run_program_call(const Line& line, const Word& code) {
  Call called;
  Return back;
  Fault fault;
  const bool calls = code.value == 98.0;
  if (!(calls ? read_m98(block_, options_.dialect, called, fault)
              : read_m99(block_, back, fault))) {
    diagnostics_.add({line.number, fault.offset + 1}, *fault.page, std::move(fault.message));
    return;
  }
  remove_call(block_, code);
  if ((block_.present & ~letter_bit('N')) != 0 || block_.g_count + block_.m_count > 0) {
    run_block(line, true);
  }
  if (calls) {
    call(line, std::move(called));
  } else {
    return_from_call(line, back);
  }
}

void ProgramReader::Impl::return_from_call(const Line& line, const Return& back) {
  if (flow_.active() && flow_.return_from_call(back)) {
    return;
  }
  diagnostics_.add({line.number, back.offset + 1}, errors::kM99InMain,
                   "M99 in the main program: it would repeat without end and is ended here");
  interpreter_.end(line.number, "at M99");
  interpreter_.end_program({line.number, back.offset + 1});
}

// G65 calls once; G66 calls after each block that moves, until G67.
void ProgramReader::Impl::run_macro_call(const Line& line, const Word& code) {
  if (code.value == 67.0) {
    modal_call_.reset();
    return;
  }
  Call called;
  Fault fault;
  called.offset = code.offset;
  if (!read_macro_call(line.text, evaluator_, called, fault)) {
    diagnostics_.add({line.number, fault.offset + 1}, *fault.page, std::move(fault.message));
  } else if (code.value == 65.0) {
    call(line, std::move(called));
  } else {
    modal_call_ = std::move(called);
    modal_depth_ = flow_.call_depth();
  }
}

// True: the block is done with.
bool ProgramReader::Impl::run_call(const Line& line, bool complete) {
  if (options_.dialect == Dialect::fanuc) {
    if (const Word* const code = find_macro_code(block_)) {
      run_macro_call(line, *code);
      return true;
    }
  }
  const Word* const code = complete ? find_m98_or_m99(block_) : nullptr;
  if (code != nullptr) {
    run_program_call(line, *code);
  }
  return code != nullptr;
}

void ProgramReader::Impl::read_line(const Line& line) {
  if (line.too_long) {
    diagnostics_.add({line.number, static_cast<std::uint32_t>(LineSplitter::kMaxLine) + 1},
                     errors::kLineTooLong,
                     joined({"the line is longer than the limit of ",
                             std::to_string(LineSplitter::kMaxLine), " bytes"}));
    any_block_ = true;
    return;
  }
  const std::size_t at = first_visible(line.text);
  if (at == std::string_view::npos) {
    return;
  }
  if ((line.text[at] == '%' && read_percent(line, at)) ||
      (line.text[at] == '/' && options_.block_delete)) {
    return;
  }
  if (line.number == options_.watched_line && !watched_block_ &&
      (!flow_.active() || flow_.in_program_text())) {
    watched_block_ = WatchedBlock{std::string(line.text), interpreter_.state()};
  }
  read_code(line);
  if (options_.dialect == Dialect::fanuc && block_.remark != 0) {
    read_behind_semicolon(line);
  }
}

// The blocks that follow in the line, each with blanks in place of those before it, so that columns
// stay what they are.
void ProgramReader::Impl::read_behind_semicolon(const Line& line) {
  Line rest = line;
  while (block_.remark != 0 && reads_as_block(rest.text.substr(block_.remark)) &&
         !interpreter_.program_ended()) {
    if (called_) {
      diagnostics_.add({line.number, block_.remark}, errors::kBlockBehindCall,
                       "a block behind ';' cannot follow a call in the same line");
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

void ProgramReader::Impl::read_code(const Line& line) {
  called_ = false;
  const bool complete = read_block(line.text, block_, evaluator_);
  if (block_.remarkable) {
    warn_about(block_, {line.number, options_.dialect}, diagnostics_);
  }
  any_block_ = any_block_ || block_.assignment != 0;
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
  const bool idle = interpreter_.moves().empty();
  run_block(line, complete);
  if (modal_call_ && idle && !interpreter_.moves().empty() && block_.has_any(kAxisLetters) &&
      flow_.call_depth() == modal_depth_) {
    call(line, *modal_call_);
  }
}

void ProgramReader::Impl::reach_end() {
  ended_ = true;
  diagnostics_.at_line(0, {});
  const std::uint32_t last = input_.lines();
  interpreter_.end(last, "at the end of the file");
  if (flow_.stopped()) {
    return;
  }
  if (!any_block_ && !flow_.has_statements()) {
    diagnostics_.add({1, 1}, errors::kEmptyProgram, "the program is empty");
  } else if (opened_by_percent_) {
    diagnostics_.add({opening_line_, 1}, errors::kUnclosedPercent,
                     "the file starts with '%' but has no closing '%'");
  } else {
    diagnostics_.add({last, 1}, errors::kNoProgramEnd,
                     "the program has no M2, M30 or '%' at its end");
  }
}

// Whether the text has to be kept from this line on.
bool ProgramReader::Impl::begins_flow(std::string_view text) const {
  if (flow_.keeps_from_start()) {
    return true;
  }
  std::size_t at = first_visible(text);
  const char first = at == std::string_view::npos ? ' ' : text[at];
  if (first == 'N' || first == 'n' || first == '/') {
    if (first == '/' && options_.block_delete) {
      return false;
    }
    at = find_block_start(text).at;
  }
  if (!may_be_statement(text, at, options_.dialect)) {
    return false;
  }
  Statement statement;
  Fault fault;
  return read_statement(text, at, options_.dialect, statement, fault) &&
         (statement.keyword != Keyword::program || any_block_);
}

bool ProgramReader::Impl::next_plain_line(Line& line) {
  if (input_.next(line)) {
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
bool ProgramReader::Impl::next_line(Line& line) {
  while (!ended_) {
    if (!flow_.active()) {
      if (!next_plain_line(line)) {
        return false;
      }
      if (!begins_flow(line.text)) {
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

bool ProgramReader::Impl::next(Move& move) {
  while (interpreter_.moves().empty()) {
    Line line;
    if (!next_line(line)) {
      return false;
    }
    diagnostics_.at_line(line.number, line.text);
    if (ended_) {
      read_rest(line);
      continue;
    }
    read_line(line);
    if (diagnostics_.full()) {
      diagnostics_.add({line.number, 1}, errors::kTooManyErrors,
                       "too many errors: the rest is not read");
      ended_ = rest_reported_ = true;
    }
    ended_ = ended_ || interpreter_.program_ended();
  }
  interpreter_.moves().pop(move);
  all_fetched_ = interpreter_.moves().empty();
  constexpr std::size_t kMotions = 3;  // lines, arcs and splines come first
  if (move.shape.index() < kMotions) {
    flow_.moved();
  }
  return true;
}

ProgramReader::ProgramReader(ReaderOptions options) : impl_(std::make_unique<Impl>(options)) {}
ProgramReader::~ProgramReader() = default;
ProgramReader::ProgramReader(ProgramReader&&) noexcept = default;
ProgramReader& ProgramReader::operator=(ProgramReader&&) noexcept = default;

void ProgramReader::feed(std::string_view bytes) {
  impl_->input().feed(bytes);
}
void ProgramReader::finish() {
  impl_->input().finish();
}
bool ProgramReader::next(Move& move) {
  return impl_->next(move);
}
bool ProgramReader::at_end() const {
  return impl_->at_end();
}
const std::optional<WatchedBlock>& ProgramReader::watched_block() const {
  return impl_->watched_block();
}
bool ProgramReader::has_errors() const {
  return impl_->diagnostics().has_errors();
}
std::size_t ProgramReader::held_bytes() const {
  return impl_->held_bytes();
}
std::string_view ProgramReader::file_name(std::uint16_t file) const {
  return impl_->file_name(file);
}
const std::vector<Diagnostic>& ProgramReader::diagnostics() const {
  return impl_->diagnostics().all();
}

}  // namespace kerf::parser
