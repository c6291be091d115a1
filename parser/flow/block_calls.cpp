#include "parser/flow/block_calls.hpp"

#include <cmath>
#include <string>

#include "diagnostics/errors/pages.hpp"
#include "parser/flow/statement_reader.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

using diagnostics::Expected;

namespace {

using diagnostics::Done;
using diagnostics::fail;

constexpr double kLargestNumber = 99'999'999.0;

bool is_whole(double value, double least, double most) {
  return value >= least && value <= most && value == std::floor(value);
}

// P and L, as they are read from words or from macro arguments.
struct Numbers {
  std::string_view name;
  double program = 0.0;
  double runs = 1.0;
  std::size_t program_at = 0;
  std::size_t runs_at = 0;
};

Expected<Call> with_numbers(const Numbers& numbers, Call call) {
  const bool by_name = !call.label.empty();
  if (!by_name && !is_whole(numbers.program, 1.0, kLargestNumber)) {
    return fail(numbers.program_at, errors::kProgramNumber,
                joined({numbers.name, ": P must be a whole number from 1 to 99999999, found ",
                        shortest(numbers.program)}));
  }
  if (!is_whole(numbers.runs, 0.0, kLargestNumber)) {
    return fail(numbers.runs_at, errors::kRepeatCount,
                joined({numbers.name, ": L must be a whole number from 0 to 99999999, found ",
                        shortest(numbers.runs)}));
  }
  if (!by_name) {
    call.label = shortest(numbers.program);
  }
  call.runs = static_cast<std::uint64_t>(numbers.runs);
  return call;
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
  MacroCall(std::string_view line, Evaluator& evaluator, std::string label)
      : line_(line), evaluator_(&evaluator) {
    call_.kind = CallKind::macro;
    call_.label = std::move(label);
    call_.arguments = call_.values.size();
    call_.values.fill(kVacant);
  }

  Expected<Call> read() {
    evaluator_->begin_line();
    for (std::size_t at = find_block_start(line_).at;;) {
      at = skip_comments(at);
      if (at >= line_.size() || line_[at] == ';') {
        break;
      }
      if (Done done = read_word(at); !done) {
        return fault_of(done);
      }
    }
    const bool by_name = !call_.label.empty();
    if (by_name && has_program_) {
      return fail(numbers_.program_at, errors::kProgramGivenTwice,
                  joined({numbers_.name, ": the program is given by its name and by P"}));
    }
    if (!by_name && !has_program_) {
      return fail(call_.offset, errors::kM98WithoutP, joined({numbers_.name, " needs P"}));
    }
    return with_numbers(numbers_, std::move(call_));
  }

 private:
  [[nodiscard]] std::size_t skip_comments(std::size_t at) const {
    at = skip_blanks(line_, at);
    while (at < line_.size() && line_[at] == '(') {
      const std::size_t close = line_.find(')', at);
      at = skip_blanks(line_, close == std::string_view::npos ? line_.size() : close + 1);
    }
    return at;
  }

  Done read_word(std::size_t& at) {
    const std::string letter = upper(line_.substr(at, 1));
    if (letter.empty() || letter[0] < 'A' || letter[0] > 'Z') {
      return fail(at, errors::kArgument,
                  joined({numbers_.name, ": an argument letter is expected, found ",
                          quoted(line_.substr(at))}));
    }
    Cursor cursor{line_, skip_blanks(line_, at + 1)};
    Word word{.offset = static_cast<std::uint32_t>(at)};
    if (!evaluator_->read_value(cursor, word.value)) {
      return diagnostics::failure(evaluator_->fault());
    }
    at = cursor.at;
    return use(letter[0], word);
  }

  Done use(char letter, const Word& word) {
    if (letter == 'G' && (word.value == 65.0 || word.value == 66.0)) {
      call_.offset = word.offset;
      numbers_.name = word.value == 65.0 ? "G65" : "G66";
      return {};
    }
    if (letter == 'P') {
      numbers_.program = word.value;
      numbers_.program_at = word.offset;
      has_program_ = true;
      return {};
    }
    if (letter == 'L') {
      numbers_.runs = word.value;
      numbers_.runs_at = word.offset;
      return {};
    }
    std::size_t variable = variable_of(letter);
    if (variable == 0) {
      return fail(word.offset, errors::kArgument,
                  joined({named(letter), " cannot be a macro argument"}));
    }
    if (variable >= 4 && variable <= 6) {
      set_ += variable <= last_in_set_ ? 1 : 0;
      last_in_set_ = variable;
      variable += 3 * set_;
      if (set_ >= 10) {
        return fail(word.offset, errors::kArgument, "at most 10 sets of I, J and K are allowed");
      }
    }
    call_.values[variable - 1] = word.value;
    return {};
  }

  std::string_view line_;
  Evaluator* evaluator_;
  Call call_;
  Numbers numbers_{.name = "G65"};
  std::size_t set_ = 0;          // of I, J and K
  std::size_t last_in_set_ = 0;  // the variable of the last of them, in the first set
  bool has_program_ = false;
};

}  // namespace

Expected<Call> read_program_call(const BlockWords& block, const Word& code, Dialect dialect,
                                 std::string label) {
  const bool local = code.value == 97.0;
  const std::string_view name = local ? "M97" : "M98";
  const bool by_name = !label.empty();
  if (by_name && block.has('P')) {
    return fail(block.word('P').offset, errors::kProgramGivenTwice,
                joined({name, ": the program is given by its name and by P"}));
  }
  if (!by_name && !block.has('P')) {
    return fail(code.offset, errors::kM98WithoutP,
                joined({name, local ? " needs P (the number of the block to go to)"
                                    : " needs P (the subprogram's number)"}));
  }
  Numbers numbers{.name = name,
                  .program = block.value_or('P', 0.0),
                  .runs = block.value_or('L', 1.0),
                  .program_at = block.has('P') ? block.word('P').offset : code.offset,
                  .runs_at = block.has('L') ? block.word('L').offset : code.offset};
  const bool both = rules_of(dialect).repeats_in_p && !local && !block.has('L') &&
                    numbers.program > 9999.0 && is_whole(numbers.program, 0.0, kLargestNumber);
  if (both) {
    numbers.runs = std::floor(numbers.program / 10000.0);
    numbers.program -= numbers.runs * 10000.0;
  }
  return with_numbers(numbers, {.kind = local ? CallKind::local : CallKind::program,
                                .label = std::move(label),
                                .offset = code.offset});
}

Expected<Return> read_m99(const BlockWords& block, const Word& code) {
  constexpr double kLargestLineNumber = 999'999'999.0;
  Return back{.offset = code.offset};
  if (!block.has('P')) {
    return back;
  }
  back.number_offset = block.word('P').offset;
  if (!is_whole(block.value('P'), 1.0, kLargestLineNumber)) {
    return fail(back.number_offset, errors::kTargetNumber,
                joined({"M99: P must be a whole number from 1 to 999999999, found ",
                        shortest(block.value('P'))}));
  }
  back.line_number = static_cast<std::uint32_t>(block.value('P'));
  return back;
}

void remove_call(BlockWords& block, const Word& code) {
  const auto place = static_cast<std::size_t>(&code - block.m.data());
  for (std::size_t i = place + 1; i < block.m_count; ++i) {
    block.m[i - 1] = block.m[i];
  }
  --block.m_count;
  block.present &= ~letters('P', 'L');
}

Expected<Call> read_macro_call(std::string_view line, Evaluator& evaluator, std::string label) {
  return MacroCall(line, evaluator, std::move(label)).read();
}

}  // namespace kerf::parser
