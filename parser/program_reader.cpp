#include "parser/program_reader.hpp"

#include "parser/block_grammar.hpp"
#include "parser/errors/characters.hpp"
#include "parser/errors/files.hpp"
#include "parser/errors/variables.hpp"
#include "parser/errors/words.hpp"
#include "parser/file_error.hpp"
#include "parser/interpreter.hpp"
#include "parser/line_splitter.hpp"
#include "parser/text.hpp"

namespace kerf::parser {

namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::size_t first_visible(std::string_view text) {
  return text.find_first_not_of(kBlanks);
}

bool has_words_beside_number(const Block& block) {
  return block.g_count + block.m_count != 0 || (block.present & ~letter_bit('N')) != 0;
}

}  // namespace

class ProgramReader::Impl {
 public:
  explicit Impl(const ReaderOptions& options)
      : options_(options),
        diagnostics_(options.max_errors),
        interpreter_(options.start_mm, diagnostics_, options.machine, options.dialect),
        parameters_(options.dialect),
        evaluator_(parameters_) {
    parameters_.use(interpreter_.values());
  }

  LineSplitter lines_;

  bool next(Move& move);
  [[nodiscard]] bool at_end() const { return ended_ && all_fetched_; }
  [[nodiscard]] const DiagnosticList& diagnostics() const { return diagnostics_; }
  [[nodiscard]] const std::optional<WatchedBlock>& watched_block() const { return watched_block_; }

 private:
  void read_line(const Line& line);
  bool read_first_line(Line& line);
  bool read_percent(const Line& line, std::size_t at);
  void read_rest(const Line& line);
  void warn_about(const Block& block, std::uint32_t line);
  bool is_program_number(const Block& block, std::uint32_t line);
  void reach_end();
  void refuse(std::uint32_t line, Fault fault);

  ReaderOptions options_;
  DiagnosticList diagnostics_;
  Interpreter interpreter_;
  Parameters parameters_;
  Evaluator evaluator_;
  Block block_;
  bool ended_ = false;       // the program, not the bytes
  bool all_fetched_ = true;  // all its moves are fetched
  bool any_block_ = false;
  bool opened_by_percent_ = false;
  bool closed_by_percent_ = false;
  bool rest_reported_ = false;
  std::uint32_t opening_line_ = 0;
  std::optional<WatchedBlock> watched_block_;
};

void ProgramReader::Impl::refuse(std::uint32_t line, Fault fault) {
  diagnostics_.add({line, fault.offset + 1}, *fault.page, std::move(fault.message));
  ended_ = true;
  rest_reported_ = true;
}

// What can be wrong with the file as a whole. False: nothing of it is to be read.
bool ProgramReader::Impl::read_first_line(Line& line) {
  if (line.text.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    line.text.remove_prefix(kByteOrderMark.size());
    diagnostics_.add({1, 1}, errors::kByteOrderMark, "byte order mark ignored");
  }
  Fault fault = explain_first_line(line.text);
  if (!fault.message.empty()) {
    refuse(1, std::move(fault));
    return false;
  }
  return true;
}

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

void ProgramReader::Impl::warn_about(const Block& block, std::uint32_t line) {
  if (block.blank_in_number != 0) {
    const std::string_view rest = block.line.substr(block.blank_in_number - 1, 40);
    diagnostics_.add({line, block.blank_in_number}, errors::kBlankInNumber,
                     joined({"a number contains a blank: ", quoted(rest), " is read as one"}));
  }
  if (block.stale_read != 0) {
    const std::string_view rest = block.line.substr(block.stale_read - 1, 40);
    diagnostics_.add({line, block.stale_read}, errors::kStaleRead,
                     joined({"the variable at ", quoted(rest),
                             " is set in the same block: its value from before is used"}));
  } else if (options_.dialect == Dialect::rs274 && block.assignment != 0 &&
             has_words_beside_number(block)) {
    diagnostics_.add({line, block.assignment}, errors::kAssignmentAmongWords,
                     "the assignment takes effect behind the words of its block");
  }
  if (block.numbered_delete) {
    diagnostics_.add({line, 1}, errors::kNumberedBlockDelete,
                     "numbered block delete is taken as '/'");
  }
  if (block.line_number_decimal) {
    diagnostics_.add({line, block.word('N').offset + 1}, errors::kLineNumberWithPoint,
                     joined({upper(block.text(block.word('N')).substr(0, 40)),
                             ": the line number has a decimal part"}));
  }
  if (block.remark != 0) {
    const std::string_view remark = block.line.substr(block.remark);
    const std::size_t last = remark.find_last_not_of(kBlanks);
    if (last != std::string_view::npos && remark[last] == ';') {
      diagnostics_.add({line, block.remark}, errors::kSemicolonAtEnd,
                       joined({"the text after ';' is taken as a comment: ", quoted(remark)}));
    }
  }
}

// O1234 at the head of the program. True: the block is done with.
bool ProgramReader::Impl::is_program_number(const Block& block, std::uint32_t line) {
  if (!block.has('O')) {
    return false;
  }
  const bool alone = block.present == letter_bit('O') && block.g_count + block.m_count == 0;
  const double number = block.value('O');
  if (any_block_ || !alone || number < 0.0 || number > 99'999'999.0 ||
      number != static_cast<double>(static_cast<long>(number))) {
    diagnostics_.add({line, block.word('O').offset + 1}, errors::kProgramNumberNotFirst,
                     "O: subprograms and o-words are not supported yet, a program number is "
                     "expected only at the head of the program");
  }
  return true;
}

void ProgramReader::Impl::read_line(const Line& given) {
  Line line = given;
  if (line.number == 1 && !read_first_line(line)) {
    return;
  }
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
  if (line.number == options_.watched_line && !watched_block_) {
    watched_block_ = WatchedBlock{std::string(line.text), interpreter_.state()};
  }
  const bool complete = read_block(line.text, block_, evaluator_);
  if (block_.remarkable) {
    warn_about(block_, line.number);
  }
  any_block_ = any_block_ || block_.assignment != 0;
  if (complete && (block_.empty() || is_program_number(block_, line.number))) {
    return;
  }
  any_block_ = true;
  interpreter_.run(block_, line.number, complete);
}

void ProgramReader::Impl::reach_end() {
  ended_ = true;
  diagnostics_.at_line(0, {});
  const std::uint32_t last = lines_.lines();
  interpreter_.end(last, "at the end of the file");
  if (!any_block_) {
    diagnostics_.add({1, 1}, errors::kEmptyProgram, "the program is empty");
  } else if (opened_by_percent_) {
    diagnostics_.add({opening_line_, 1}, errors::kUnclosedPercent,
                     "the file starts with '%' but has no closing '%'");
  } else {
    diagnostics_.add({last, 1}, errors::kNoProgramEnd,
                     "the program has no M2, M30 or '%' at its end");
  }
}

bool ProgramReader::Impl::next(Move& move) {
  while (interpreter_.moves().empty()) {
    Line line;
    if (!lines_.next(line)) {
      if (lines_.finished() && !ended_) {
        reach_end();
      }
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
  return true;
}

ProgramReader::ProgramReader(ReaderOptions options) : impl_(std::make_unique<Impl>(options)) {}
ProgramReader::~ProgramReader() = default;
ProgramReader::ProgramReader(ProgramReader&&) noexcept = default;
ProgramReader& ProgramReader::operator=(ProgramReader&&) noexcept = default;

void ProgramReader::feed(std::string_view bytes) {
  impl_->lines_.feed(bytes);
}
void ProgramReader::finish() {
  impl_->lines_.finish();
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
const std::vector<Diagnostic>& ProgramReader::diagnostics() const {
  return impl_->diagnostics().all();
}

}  // namespace kerf::parser
