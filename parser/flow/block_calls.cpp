#include "parser/flow/block_calls.hpp"

#include <cmath>
#include <string>

#include "diagnostics/errors/pages.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kLargestNumber = 99'999'999.0;

bool is_whole(double value, double least, double most) {
  return value >= least && value <= most && value == std::floor(value);
}

diagnostics::Fault fault_at(std::size_t offset, const diagnostics::ErrorPage& page,
                            std::string message) {
  return {static_cast<std::uint32_t>(offset), std::move(message), &page};
}

// P and L, as they are read from words or from macro arguments.
struct Numbers {
  std::string_view name;
  double program = 0.0;
  double runs = 1.0;
  std::size_t program_at = 0;
  std::size_t runs_at = 0;
};

bool set_numbers(const Numbers& numbers, Call& call, diagnostics::Fault& fault) {
  const bool by_name = !call.label.empty();
  if (!by_name && !is_whole(numbers.program, 1.0, kLargestNumber)) {
    fault = fault_at(numbers.program_at, errors::kProgramNumber,
                     joined({numbers.name, ": P must be a whole number from 1 to 99999999, found ",
                             shortest(numbers.program)}));
    return false;
  }
  if (!is_whole(numbers.runs, 0.0, kLargestNumber)) {
    fault = fault_at(numbers.runs_at, errors::kRepeatCount,
                     joined({numbers.name, ": L must be a whole number from 0 to 99999999, found ",
                             shortest(numbers.runs)}));
    return false;
  }
  if (!by_name) {
    call.label = shortest(numbers.program);
  }
  call.runs = static_cast<std::uint64_t>(numbers.runs);
  return true;
}

// The number of the variable that a letter sets, 0: none. I, J and K are the first set.
std::size_t variable_of(char letter) {
  constexpr std::string_view kLetters = "ABCIJKDEFHMQRSTUVWXYZ";
  constexpr std::array<std::size_t, 21> kVariables{1,  2,  3,  4,  5,  6,  7,  8,  9,  11, 13,
                                                   17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  const std::size_t place = kLetters.find(letter);
  return place == std::string_view::npos ? 0 : kVariables[place];
}

// Goes through the words of a macro call.
class MacroCall {
 public:
  MacroCall(std::string_view line, Evaluator& evaluator, Call& call, diagnostics::Fault& fault)
      : line_(line), evaluator_(&evaluator), call_(&call), fault_(&fault) {
    call.kind = CallKind::macro;
    call.arguments = call.values.size();
    call.values.fill(kVacant);
  }

  bool read() {
    evaluator_->begin_line();
    for (std::size_t at = find_block_start(line_).at;;) {
      at = skip_comments(at);
      if (at >= line_.size() || line_[at] == ';') {
        break;
      }
      if (!read_word(at)) {
        return false;
      }
    }
    const bool by_name = !call_->label.empty();
    if (by_name && has_program_) {
      return refuse(numbers_.program_at, errors::kProgramGivenTwice,
                    joined({name_, ": the program is given by its name and by P"}));
    }
    if (!by_name && !has_program_) {
      return refuse(call_->offset, errors::kM98WithoutP, joined({name_, " needs P"}));
    }
    numbers_.name = name_;
    return set_numbers(numbers_, *call_, *fault_);
  }

 private:
  bool refuse(std::size_t offset, const diagnostics::ErrorPage& page, std::string message) {
    *fault_ = fault_at(offset, page, std::move(message));
    return false;
  }

  std::size_t skip_comments(std::size_t at) const {
    at = skip_blanks(line_, at);
    while (at < line_.size() && line_[at] == '(') {
      const std::size_t close = line_.find(')', at);
      at = skip_blanks(line_, close == std::string_view::npos ? line_.size() : close + 1);
    }
    return at;
  }

  bool read_word(std::size_t& at) {
    const std::size_t from = at;
    const std::string letter = upper(line_.substr(at, 1));
    if (letter.empty() || letter[0] < 'A' || letter[0] > 'Z') {
      return refuse(
          from, errors::kArgument,
          joined({name_, ": an argument letter is expected, found ", quoted(line_.substr(from))}));
    }
    Cursor cursor{line_, skip_blanks(line_, at + 1)};
    double value = 0.0;
    if (!evaluator_->read_value(cursor, value)) {
      *fault_ = evaluator_->fault();
      return false;
    }
    at = cursor.at;
    return use(letter[0], value, from);
  }

  bool use(char letter, double value, std::size_t at) {
    if (letter == 'G' && (value == 65.0 || value == 66.0)) {
      call_->offset = static_cast<std::uint32_t>(at);
      name_ = value == 65.0 ? "G65" : "G66";
      return true;
    }
    if (letter == 'P') {
      numbers_.program = value;
      numbers_.program_at = at;
      has_program_ = true;
      return true;
    }
    if (letter == 'L') {
      numbers_.runs = value;
      numbers_.runs_at = at;
      return true;
    }
    std::size_t variable = variable_of(letter);
    if (variable == 0) {
      return refuse(at, errors::kArgument, joined({named(letter), " cannot be a macro argument"}));
    }
    if (variable >= 4 && variable <= 6) {
      set_ += variable <= last_in_set_ ? 1 : 0;
      last_in_set_ = variable;
      variable += 3 * set_;
      if (set_ >= 10) {
        return refuse(at, errors::kArgument, "at most 10 sets of I, J and K are allowed");
      }
    }
    call_->values[variable - 1] = value;
    return true;
  }

  std::string_view line_;
  Evaluator* evaluator_;
  Call* call_;
  diagnostics::Fault* fault_;
  Numbers numbers_;
  std::string_view name_ = "G65";
  std::size_t set_ = 0;          // of I, J and K
  std::size_t last_in_set_ = 0;  // the variable of the last of them, in the first set
  bool has_program_ = false;
};

}  // namespace

bool read_program_call(const Block& block, const Word& code, Dialect dialect, Call& call,
                       diagnostics::Fault& fault) {
  const bool local = code.value == 97.0;
  const std::string_view name = local ? "M97" : "M98";
  call.kind = local ? CallKind::local : CallKind::program;
  call.offset = code.offset;
  const bool by_name = !call.label.empty();
  if (by_name && block.has('P')) {
    fault = fault_at(block.word('P').offset, errors::kProgramGivenTwice,
                     joined({name, ": the program is given by its name and by P"}));
    return false;
  }
  if (!by_name && !block.has('P')) {
    fault = fault_at(code.offset, errors::kM98WithoutP,
                     joined({name, local ? " needs P (the number of the block to go to)"
                                         : " needs P (the subprogram's number)"}));
    return false;
  }
  Numbers numbers{.name = name,
                  .program = block.value_or('P', 0.0),
                  .runs = block.value_or('L', 1.0),
                  .program_at = block.has('P') ? block.word('P').offset : code.offset,
                  .runs_at = block.has('L') ? block.word('L').offset : code.offset};
  const bool both = rules_of(dialect).macro_b && !local && !block.has('L') &&
                    numbers.program > 9999.0 && is_whole(numbers.program, 0.0, kLargestNumber);
  if (both) {
    numbers.runs = std::floor(numbers.program / 10000.0);
    numbers.program -= numbers.runs * 10000.0;
  }
  return set_numbers(numbers, call, fault);
}

bool read_m99(const Block& block, const Word& code, Return& back, diagnostics::Fault& fault) {
  constexpr double kLargestLineNumber = 999'999'999.0;
  back.offset = code.offset;
  if (!block.has('P')) {
    return true;
  }
  back.number_offset = block.word('P').offset;
  if (!is_whole(block.value('P'), 1.0, kLargestLineNumber)) {
    fault = fault_at(back.number_offset, errors::kTargetNumber,
                     joined({"M99: P must be a whole number from 1 to 999999999, found ",
                             shortest(block.value('P'))}));
    return false;
  }
  back.line_number = static_cast<std::uint32_t>(block.value('P'));
  return true;
}

void remove_call(Block& block, const Word& code) {
  const auto place = static_cast<std::size_t>(&code - block.m.data());
  for (std::size_t i = place + 1; i < block.m_count; ++i) {
    block.m[i - 1] = block.m[i];
  }
  --block.m_count;
  block.present &= ~letters('P', 'L');
}

bool read_macro_call(std::string_view line, Evaluator& evaluator, Call& call,
                     diagnostics::Fault& fault) {
  return MacroCall(line, evaluator, call, fault).read();
}

}  // namespace kerf::parser
