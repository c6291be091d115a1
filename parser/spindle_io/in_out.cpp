#include <algorithm>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/spindle_io/switches.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kLongestWait_s = 1e6;

// The number of an input or output in word `letter`.
Expected<int> channel(const RunningBlock& at, char letter, int count) {
  const Word& code = at.code_word(Group::in_out);
  const std::string name = upper(at.block.text(code));
  const std::string range = joined({named(letter), " must be 0 to ", std::to_string(count - 1)});
  if (!at.block.has(letter)) {
    return fail(code.offset, errors::kChannelMissing, joined({name, " needs ", named(letter)}));
  }
  const Word& word = at.block.word(letter);
  if (word.value != std::floor(word.value) || word.value < 0.0 || word.value >= count) {
    return fail(word.offset, errors::kChannelOutOfRange,
                joined({name, ": ", range, ", found ", shortest(word.value)}));
  }
  return static_cast<int>(word.value);
}

// How long M66 waits: Q, which a wait of any kind but 0 needs.
Expected<double> waiting_time_s(const RunningBlock& at, double kind) {
  const double wait_s = at.block.value_or('Q', 0.0);
  if (wait_s < 0.0 || wait_s > kLongestWait_s || (kind != 0.0 && wait_s == 0.0)) {
    const Word& word = at.block.has('Q') ? at.block.word('Q') : at.code_word(Group::in_out);
    return fail(
        word.offset, errors::kWaitTime,
        joined({"M66 L", shortest(kind), ": Q (seconds) must be ",
                kind == 0.0 ? "0 or more" : "greater than 0", ", found ", shortest(wait_s)}));
  }
  return wait_s;
}

// Of inputs that keep their value: a wait for another one lasts until its time is up. The tool
// rests for any answer.
void assume_input(const RunningBlock& at, ModalState& state, const MachineSource& source,
                  const MachineQuestion& asked) {
  using Kind = MachineQuestion::Kind;
  const AssumedMachine* machine = source.assumed.get();
  const auto channel = static_cast<std::size_t>(asked.channel);
  const bool is_high = machine != nullptr && machine->digital(channel);
  const bool in_vain = asked.kind == Kind::rise || asked.kind == Kind::fall ||
                       (asked.kind == Kind::high && !is_high) ||
                       (asked.kind == Kind::low && is_high);
  if (state.assumed_input_line == 0) {
    state.assumed_input_line = at.source.line;
  }
  if (in_vain) {
    state.input = -1.0;
  } else if (asked.kind == Kind::analog) {
    state.input = machine != nullptr ? machine->analog(channel) : 0.0;
  } else {
    state.input = is_high ? 1.0 : 0.0;
  }
  const double more_s = in_vain ? std::max(asked.max_wait_s - source.look_s, 0.0) : 0.0;
  at.push_move(state).shape = DwellMove{.duration_s = source.answer_s + more_s, .assumed = true};
}

// M66 P reads or waits for a digital input, M66 E reads an analog one; #5399 gets the answer.
Done wait_for_input(const RunningBlock& at, ModalState& state, const MachineSource& machine) {
  const Word& code = at.code_word(Group::in_out);
  if (at.block.has('P') == at.block.has('E')) {
    return fail(code.offset, errors::kInputMissing,
                "M66 needs P (digital input) or E (analog input), and not both");
  }
  const bool analog = at.block.has('E');
  auto input = channel(at, analog ? 'E' : 'P', analog ? kAnalogOutputs : kDigitalOutputs);
  if (!input) {
    return fault_of(input);
  }
  const double kind = at.block.value_or('L', 0.0);
  if (kind != std::floor(kind) || kind < 0.0 || kind > 4.0 || (analog && kind != 0.0)) {
    return fail(at.block.word('L').offset, errors::kWaitKind,
                joined({"M66: L must be ", analog ? "0 for an analog input" : "0 to 4", ", found ",
                        shortest(kind)}));
  }
  Expected<double> wait_s = waiting_time_s(at, kind);
  if (!wait_s) {
    return fault_of(wait_s);
  }
  using Kind = MachineQuestion::Kind;
  const MachineQuestion asked{
      .kind = analog ? Kind::analog
                     : static_cast<Kind>(static_cast<int>(Kind::digital) + static_cast<int>(kind)),
      .channel = *input,
      .max_wait_s = *wait_s};
  if (machine.asks_in(at.block_number)) {
    at.push_event(state, {.kind = EventKind::ask_machine, .question = asked});
  } else {
    assume_input(at, state, machine, asked);
  }
  return {};
}

// M62 to M65.
Done switch_digital(const RunningBlock& at, ModalState& state) {
  const Tenths code = at.codes[Group::in_out];
  auto output = channel(at, 'P', kDigitalOutputs);
  if (!output) {
    return fault_of(output);
  }
  const bool at_motion = code == 620 || code == 630;
  const bool is_on = code == 620 || code == 640;
  at.push_event(state, {at_motion ? EventKind::digital_at_motion : EventKind::digital_output,
                        is_on ? 1.0 : 0.0, *output});
  const std::uint64_t bit = std::uint64_t{1} << *output;
  state.outputs.digital = is_on ? state.outputs.digital | bit : state.outputs.digital & ~bit;
  return {};
}

// M67 and M68.
Done set_analog(const RunningBlock& at, ModalState& state) {
  auto output = channel(at, 'E', kAnalogOutputs);
  if (!output) {
    return fault_of(output);
  }
  if (!at.block.has('Q')) {
    const Word& word = at.code_word(Group::in_out);
    return fail(word.offset, errors::kOutputValueMissing,
                joined({upper(at.block.text(word)), " needs Q (the value)"}));
  }
  const bool at_motion = at.codes[Group::in_out] == 670;
  at.push_event(state, {at_motion ? EventKind::analog_at_motion : EventKind::analog_output,
                        at.block.value('Q'), *output});
  state.outputs.analog[static_cast<std::size_t>(*output)] = at.block.value('Q');
  return {};
}

}  // namespace

Done switch_in_out(const RunningBlock& at, ModalState& state, const MachineSource& machine) {
  const Tenths code = at.codes[Group::in_out];
  if (code == kNoCode) {
    return {};
  }
  if (code == 660) {
    return wait_for_input(at, state, machine);
  }
  return code < 660 ? switch_digital(at, state) : set_analog(at, state);
}

}  // namespace kerf::parser
