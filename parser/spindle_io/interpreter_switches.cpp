// Tool change, coolant, inputs and outputs, overrides, saved modes, stops.
#include <cmath>

#include "diagnostics/errors/modes.hpp"
#include "diagnostics/errors/switches.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kLargestTool = 99'999'999.0;

}  // namespace

void Interpreter::push_event(EventKind kind, double value, int index) {
  push_move().shape = EventMove{kind, value, index};
}

bool Interpreter::select_tool() {
  if (!block_->has('T')) {
    return true;
  }
  const Word& word = block_->word('T');
  if (word.value < 0.0) {
    return fail(word.offset, errors::kNegativeTool, "T must not be negative");
  }
  if (word.value != std::floor(word.value)) {
    return fail(word.offset, errors::kToolNotWhole, "T must be a whole number");
  }
  if (word.value > kLargestTool) {
    return fail(word.offset, errors::kToolOutOfRange,
                joined({"T: value ", upper(block_->text(word).substr(1, 40)), " is out of range"}));
  }
  if (table_tool(word.value, word.offset) == nullptr) {
    return false;
  }
  state_.tool = word.value;
  state_.tool_selected = true;
  return true;
}

// The M codes in the order of RS274/NGC.
bool Interpreter::switch_machine() {
  if (!(switch_in_out() && change_tool() && start_spindle() && keep_modes())) {
    return false;
  }
  switch_coolant();
  return switch_overrides();
}

// M6, which stops the spindle, and M61 Q, which only says which tool is in it.
bool Interpreter::change_tool() {
  if (!codes_.has(Group::tool)) {
    return true;
  }
  const Word& code = code_word(*block_, codes_, Group::tool);
  if (codes_[Group::tool] == 60) {
    if (!state_.tool_selected) {
      warn(code.offset, errors::kToolChangeWithoutTool, "M6 with no tool selected (T)");
    }
    state_.spindle = Spindle::off;
    state_.loaded_tool = static_cast<std::int32_t>(state_.tool);
    push_event(EventKind::tool_change, state_.tool);
    return true;
  }
  if (!block_->has('Q')) {
    return fail(code.offset, errors::kToolNumberMissing, "M61 needs Q (the tool's number)");
  }
  const Word& word = block_->word('Q');
  if (word.value < 0.0 || word.value != std::floor(word.value) || word.value > kLargestTool) {
    return fail(word.offset, errors::kToolNumberMissing,
                joined({"M61: Q must be a tool's number, found ", shortest(word.value)}));
  }
  if (table_tool(word.value, word.offset) == nullptr) {
    return false;
  }
  state_.loaded_tool = static_cast<std::int32_t>(word.value);
  push_event(EventKind::tool_number, word.value);
  return true;
}

void Interpreter::switch_coolant() {
  const Tenths code = codes_[Group::coolant];
  if (code == kNoCode) {
    return;
  }
  state_.mist = code == 70 || (code == 80 && state_.mist);
  state_.flood = code == 80 || (code == 70 && state_.flood);
  push_event(code == 70   ? EventKind::mist_on
             : code == 80 ? EventKind::flood_on
                          : EventKind::coolant_off,
             0.0);
}

// M48 and M49 switch both overrides; M50 to M53 one thing each, off with P0.
bool Interpreter::switch_overrides() {
  const Tenths code = codes_[Group::overrides];
  if (code == kNoCode) {
    return true;
  }
  Overrides& overrides = state_.overrides;
  if (code == 480 || code == 490) {
    overrides.feed = overrides.speed = code == 480;
    return true;
  }
  const double p = block_->value_or('P', 1.0);
  if (p != 0.0 && p != 1.0) {
    return fail(block_->word('P').offset, errors::kSwitchValue,
                joined({upper(block_->text(code_word(*block_, codes_, Group::overrides))),
                        ": P must be 0 or 1, found ", shortest(p)}));
  }
  (code == 500   ? overrides.feed
   : code == 510 ? overrides.speed
   : code == 520 ? overrides.adaptive_feed
                 : overrides.feed_hold) = p == 1.0;
  return true;
}

void Interpreter::stop() {
  const Tenths code = codes_[Group::stop];
  if (code == kNoCode) {
    return;
  }
  if (code == 20 || code == 300) {
    push_event(EventKind::program_end, 0.0);
    program_ended_ = true;
    return;
  }
  push_event(code == 0    ? EventKind::program_stop
             : code == 10 ? EventKind::optional_stop
                          : EventKind::pallet_change,
             0.0);
}

}  // namespace kerf::parser
