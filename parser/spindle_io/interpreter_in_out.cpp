// M62 to M68: digital and analog outputs, waiting for an input.
#include <cmath>

#include "diagnostics/errors/switches.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kLongestWait_s = 1e6;

}  // namespace

// The number of an input or output in word `letter`; nothing, with the fault, where it is none.
std::optional<int> Interpreter::channel(char letter, int count) {
  const Word& code = code_word(*block_, codes_, Group::in_out);
  const std::string name = upper(block_->text(code));
  const std::string range = joined({named(letter), " must be 0 to ", std::to_string(count - 1)});
  if (!block_->has(letter)) {
    fail(code.offset, errors::kChannelMissing, joined({name, " needs ", named(letter)}));
    return std::nullopt;
  }
  const Word& word = block_->word(letter);
  if (word.value != std::floor(word.value) || word.value < 0.0 || word.value >= count) {
    fail(word.offset, errors::kChannelOutOfRange,
         joined({name, ": ", range, ", found ", shortest(word.value)}));
    return std::nullopt;
  }
  return static_cast<int>(word.value);
}

bool Interpreter::switch_in_out() {
  const Tenths code = codes_[Group::in_out];
  if (code == kNoCode) {
    return true;
  }
  if (code == 660) {
    return wait_for_input();
  }
  if (code < 660) {
    const auto output = channel('P', kDigitalOutputs);
    if (!output) {
      return false;
    }
    const bool at_motion = code == 620 || code == 630;
    push_event(at_motion ? EventKind::digital_at_motion : EventKind::digital_output,
               code == 620 || code == 640 ? 1.0 : 0.0, *output);
    return true;
  }
  const auto output = channel('E', kAnalogOutputs);
  if (!output) {
    return false;
  }
  if (!block_->has('Q')) {
    const Word& word = code_word(*block_, codes_, Group::in_out);
    return fail(word.offset, errors::kOutputValueMissing,
                joined({upper(block_->text(word)), " needs Q (the value)"}));
  }
  push_event(code == 670 ? EventKind::analog_at_motion : EventKind::analog_output,
             block_->value('Q'), *output);
  return true;
}

// M66 P reads or waits for a digital input, M66 E reads an analog one; #5399 gets the answer. The
// table is simulated and its inputs are low: a wait for low is over at once, every other one lasts
// Q seconds and is in vain.
bool Interpreter::wait_for_input() {
  const Word& code = code_word(*block_, codes_, Group::in_out);
  if (block_->has('P') == block_->has('E')) {
    return fail(code.offset, errors::kInputMissing,
                "M66 needs P (digital input) or E (analog input), and not both");
  }
  const bool analog = block_->has('E');
  if (!channel(analog ? 'E' : 'P', analog ? kAnalogOutputs : kDigitalOutputs)) {
    return false;
  }
  const double kind = block_->value_or('L', 0.0);
  if (kind != std::floor(kind) || kind < 0.0 || kind > 4.0 || (analog && kind != 0.0)) {
    return fail(block_->word('L').offset, errors::kWaitKind,
                joined({"M66: L must be ", analog ? "0 for an analog input" : "0 to 4", ", found ",
                        shortest(kind)}));
  }
  const double wait_s = block_->value_or('Q', 0.0);
  if (wait_s < 0.0 || wait_s > kLongestWait_s || (kind != 0.0 && wait_s == 0.0)) {
    return fail(
        block_->has('Q') ? block_->word('Q').offset : code.offset, errors::kWaitTime,
        joined({"M66 L", shortest(kind), ": Q (seconds) must be ",
                kind == 0.0 ? "0 or more" : "greater than 0", ", found ", shortest(wait_s)}));
  }
  const bool in_vain = kind == 1.0 || kind == 2.0 || kind == 3.0;
  state_.input = in_vain ? -1.0 : 0.0;
  if (in_vain) {
    push_move().shape = DwellMove{wait_s};
  }
  return true;
}

}  // namespace kerf::parser
