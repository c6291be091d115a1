#include "parser/spindle_io/switches.hpp"

#include <cmath>
#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kLargestTool = 99'999'999.0;

}  // namespace

Done select_tool(const RunningBlock& at, ModalState& state, const ToolTable& tools) {
  if (!at.block.has('T')) {
    return {};
  }
  const Word& word = at.block.word('T');
  if (word.value < 0.0) {
    return fail(word.offset, errors::kNegativeTool, "T must not be negative");
  }
  if (word.value != std::floor(word.value)) {
    return fail(word.offset, errors::kToolNotWhole, "T must be a whole number");
  }
  if (word.value > kLargestTool) {
    return fail(
        word.offset, errors::kToolOutOfRange,
        joined({"T: value ", upper(at.block.text(word).substr(1, 40)), " is out of range"}));
  }
  if (auto tool = named_tool(at, tools, word.value, word.offset); !tool) {
    return fault_of(tool);
  }
  state.tool = word.value;
  state.tool_selected = true;
  return {};
}

Done change_tool(const RunningBlock& at, ModalState& state, const ToolTable& tools) {
  if (!at.codes.has(Group::tool)) {
    return {};
  }
  const Word& code = at.code_word(Group::tool);
  if (at.codes[Group::tool] == 60) {
    if (!state.tool_selected) {
      at.warn(code.offset, errors::kToolChangeWithoutTool, "M6 with no tool selected (T)");
    }
    state.spindle = Spindle::off;
    state.loaded_tool = static_cast<std::int32_t>(state.tool);
    at.push_event(state, {EventKind::tool_change, state.tool});
    return {};
  }
  if (!at.block.has('Q')) {
    return fail(code.offset, errors::kToolNumberMissing, "M61 needs Q (the tool's number)");
  }
  const Word& word = at.block.word('Q');
  if (word.value < 0.0 || word.value != std::floor(word.value) || word.value > kLargestTool) {
    return fail(word.offset, errors::kToolNumberMissing,
                joined({"M61: Q must be a tool's number, found ", shortest(word.value)}));
  }
  if (auto tool = named_tool(at, tools, word.value, word.offset); !tool) {
    return fault_of(tool);
  }
  state.loaded_tool = static_cast<std::int32_t>(word.value);
  at.push_event(state, {EventKind::tool_number, word.value});
  return {};
}

void switch_coolant(const RunningBlock& at, ModalState& state) {
  const Tenths code = at.codes[Group::coolant];
  if (code == kNoCode) {
    return;
  }
  state.mist = code == 70 || (code == 80 && state.mist);
  state.flood = code == 80 || (code == 70 && state.flood);
  at.push_event(state, {code == 70   ? EventKind::mist_on
                        : code == 80 ? EventKind::flood_on
                                     : EventKind::coolant_off});
}

void follow_overrides(const MoveSink& at, ModalState& state, const AllowedOverrides& overrides) {
  const AllowedOverrides before = std::exchange(state.overrides, overrides);
  const auto tell = [&](EventKind kind, bool was, bool is) {
    if (was != is) {
      at.push_event(state, {kind, is ? 1.0 : 0.0});
    }
  };
  tell(EventKind::speed_override, before.speed, overrides.speed);
  tell(EventKind::adaptive_feed, before.adaptive_feed, overrides.adaptive_feed);
  tell(EventKind::feed_stop, before.feed_hold, overrides.feed_hold);
}

Done switch_overrides(const RunningBlock& at, ModalState& state) {
  const Tenths code = at.codes[Group::overrides];
  if (code == kNoCode) {
    return {};
  }
  AllowedOverrides overrides = state.overrides;
  if (code == 480 || code == 490) {
    overrides.feed = overrides.speed = code == 480;
    follow_overrides(at, state, overrides);
    return {};
  }
  const double p = at.block.value_or('P', 1.0);
  if (p != 0.0 && p != 1.0) {
    return fail(at.block.word('P').offset, errors::kSwitchValue,
                joined({at.name_of(Group::overrides), ": P must be 0 or 1, found ", shortest(p)}));
  }
  (code == 500   ? overrides.feed
   : code == 510 ? overrides.speed
   : code == 520 ? overrides.adaptive_feed
                 : overrides.feed_hold) = p == 1.0;
  follow_overrides(at, state, overrides);
  return {};
}

bool stop_program(const RunningBlock& at, const ModalState& state) {
  const Tenths code = at.codes[Group::stop];
  if (code == kNoCode) {
    return false;
  }
  if (code == 20 || code == 300) {
    at.push_event(state, {EventKind::program_end});
    return true;
  }
  at.push_event(state, {code == 0    ? EventKind::program_stop
                        : code == 10 ? EventKind::optional_stop
                                     : EventKind::pallet_change});
  return false;
}

void bring_back_coolant(const MoveSink& at, const ModalState& before, const ModalState& state) {
  if (state.mist == before.mist && state.flood == before.flood) {
    return;
  }
  if ((before.mist && !state.mist) || (before.flood && !state.flood)) {
    at.push_event(state, {EventKind::coolant_off});
  }
  if (state.mist) {
    at.push_event(state, {EventKind::mist_on});
  }
  if (state.flood) {
    at.push_event(state, {EventKind::flood_on});
  }
}

}  // namespace kerf::parser
