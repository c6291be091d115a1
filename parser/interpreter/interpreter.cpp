#include "parser/interpreter/interpreter.hpp"

#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "parser/block/lexical_error.hpp"
#include "parser/compensation/compensation_codes.hpp"
#include "parser/dialects/fanuc/fanuc_codes.hpp"
#include "parser/interpreter/words.hpp"
#include "parser/spindle_io/switches.hpp"

namespace kerf::parser {

Interpreter::Interpreter(ProgramMemory start, diagnostics::DiagnosticList& diagnostics)
    : memory_(std::move(start)), rules_(&rules_of(memory_.dialect)), diagnostics_(&diagnostics) {}

void Interpreter::report(std::uint32_t line, const diagnostics::Fault& fault) {
  compensation_.forget_faults();
  if (reported_line_ != line) {
    diagnostics_->add_at(fault.elsewhere.value_or(diagnostics_->place({line, fault.offset + 1})),
                         *fault.page, fault.message);
    reported_line_ = line;
  }
}

void Interpreter::run(const BlockWords& block, std::uint32_t line, bool complete) {
  memory_.line = line;
  column_ = block.first_word + 1;
  const RunningBlock at{
      {moves_, in_file({line, column_}), ++blocks_run_, memory_.machine.extra_axes},
      block,
      codes_,
      *diagnostics_,
      *rules_};
  if (curves_.skipping() && !leaves_skipped_curve(at, complete)) {
    recover(at);
    return;
  }
  if (const Done done = complete ? execute(at) : refuse(at); !done) {
    take_fault(at, *done.error());
  }
  if (compensation_.busy()) {
    compensate_moves(at.source);
  }
}

bool Interpreter::leaves_skipped_curve(const RunningBlock& at, bool complete) {
  return complete && sort_codes(at.block, at.rules, codes_) &&
         curves_.leave_skipped(at, memory_.state);
}

[[gnu::cold]] void Interpreter::take_fault(const RunningBlock& at,
                                           const diagnostics::Fault& fault) {
  report(at.source.line, fault);
  if (curves_.open()) {
    curves_.abandon(memory_.state);
  } else {
    curves_.skip_from(at.block);
  }
  recover(at);
}

// A line in which the grammar stopped.
Done Interpreter::refuse(const RunningBlock& at) {
  Done sorted = sort_codes(at.block, at.rules, codes_);
  const bool explained = sorted || at.block.stop == Stop::too_many_g;
  return explained ? diagnostics::failure(explain_stop(at.block)) : std::move(sorted);
}

void Interpreter::end(std::uint32_t last_line, std::string_view where) {
  memory_.line = last_line;
  if (curves_.open()) {
    report(last_line, curves_.unfinished({last_line, where}));
    curves_.abandon(memory_.state);
  }
  if (compensation_.busy()) {
    const diagnostics::SourcePosition last = in_file({last_line, 1});
    compensation_.finish(diagnostics_->place(last));
    compensate_moves(last);
  }
}

void Interpreter::end_program(const diagnostics::SourcePosition& source) {
  const MoveSink at{moves_, in_file(source), blocks_run_, memory_.machine.extra_axes};
  at.push_event(memory_.state, {EventKind::program_end});
  program_ended_ = true;
}

// F, S, G96, G97 and T. Part of execute(), a call for each block would be felt.
[[gnu::always_inline]] inline Done Interpreter::set_feed_speed_and_tool(const RunningBlock& at) {
  if (!at.block.has_any(letters('F', 'S', 'T')) && !at.codes.has(Group::spindle_mode)) {
    return {};
  }
  ModalState& state = memory_.state;
  return set_feed(at, state).and_then([&] { return set_speed(at, state); }).and_then([&] {
    return select_tool(at, state, memory_.machine.tools);
  });
}

// In the order that the class names. Part of execute(), too.
[[gnu::always_inline]] inline Done Interpreter::do_words(const RunningBlock& at) {
  ModalState& state = memory_.state;
  Expected<Group> axis_taker = check_words(at, state, compensation_.on());
  if (!axis_taker) {
    return fault_of(axis_taker);
  }
  if (at.block.g_count > 0) {
    set_units_and_feed_mode(at.codes);
  }
  if (Done done = set_feed_speed_and_tool(at); !done) {
    return done;
  }
  if (at.block.m_count > 0 || at.block.has('S')) {
    if (Done done = switch_machine(at); !done) {
      return done;
    }
  }
  if (at.block.g_count > 0) {
    if (Done done = set_modes(at); !done) {
      return done;
    }
  }
  if (state.surface_speed.active) {
    spindle_.follow_moved_axis(at, state);
  }
  if (at.block.m_count == 0) {
    return move(at, *axis_taker);
  }
  Done moved = move(at, *axis_taker);
  if (moved) {
    program_ended_ = stop_program(at, state) || program_ended_;
  }
  return moved;
}

// False: the curve is given up, since its end is missing.
bool Interpreter::belongs_to_curve(const RunningBlock& at) {
  const std::optional<diagnostics::Fault> missing_end = curves_.missing_end(at);
  if (missing_end) {
    report(at.source.line, *missing_end);
    curves_.abandon(memory_.state);
    curves_.skip_no_more();
  }
  return !missing_end;
}

Done Interpreter::execute(const RunningBlock& at) {
  ModalState& state = memory_.state;
  if (Done sorted = sort_codes(at.block, at.rules, codes_); !sorted) {
    return sorted;
  }
  if (at.codes.has(Group::motion) && at.rules.cycle_group) {
    settle_cycle_group(at, codes_, state);
  }
  if (compensation_.on()) {
    if (Done allowed = allowed_while_compensating(at, state); !allowed) {
      return allowed;
    }
  }
  if (curves_.open() && belongs_to_curve(at)) {
    return curves_.add(at, state).and_then([&] { return set_feed(at, state); });
  }
  if (CurveReader::begins(at, state)) {
    return begin_curve(at);
  }
  return do_words(at);
}

// Takes what the block has put out through the compensation.
void Interpreter::compensate_moves(const diagnostics::SourcePosition& source) {
  Move move;
  while (!moves_.empty()) {
    moves_.pop(move);
    compensation_.take(move, diagnostics_->place(move.source));
  }
  if (program_ended_) {
    compensation_.finish(diagnostics_->place(source));
  }
  std::swap(moves_, compensation_.ready());
  tell_contour_faults();
}

void Interpreter::tell_contour_faults() {
  for (ContourFault& fault : compensation_.faults()) {
    diagnostics_->add_at(std::move(fault.place), *fault.page, std::move(fault.message));
  }
}

void Interpreter::enter_subprogram() {
  saved_modes_.enter_subprogram();
  memory_.open_calls = saved_modes_.open_calls();
}

void Interpreter::leave_subprogram() {
  const std::optional<ModalState> saved = saved_modes_.leave_subprogram();
  memory_.open_calls = saved_modes_.open_calls();
  if (saved) {
    bring_back({moves_, in_file({memory_.line, column_}), blocks_run_, memory_.machine.extra_axes},
               *saved);
  }
}

void Interpreter::bring_back(const MoveSink& at, const ModalState& saved) {
  ModalState& state = memory_.state;
  const ModalState before = state;
  SavedModes::bring_back(saved, memory_.machine.tools, state);
  if (compensation_.on()) {
    keep_contour_in_place(at, before);
  }
  bring_back_compensation(at, saved);
  if (state.spindle != before.spindle || state.spindle_speed != before.spindle_speed) {
    if (state.spindle == Spindle::off) {
      spindle_.turn_off(at, state);
    } else {
      spindle_.turn_on(at, state, memory_.answers);
    }
  }
  bring_back_coolant(at, before, state);
  follow_overrides(at, state, saved.overrides);
}

// Off comes back. G41 and G42 would need an entry.
void Interpreter::bring_back_compensation(const MoveSink& at, const ModalState& saved) {
  ModalState& state = memory_.state;
  if (saved.cutter_compensation == state.cutter_compensation) {
    return;
  }
  if (saved.cutter_compensation == kG40) {
    compensation_.stop();
    state.cutter_compensation = kG40;
    return;
  }
  diagnostics_->add({at.source.line, 1, at.source.file}, errors::kSavedCompensation,
                    "the saved modes (M70, M73) have G41 or G42, which is off or on the other side "
                    "by now: it cannot come back without a move on to the contour");
}

// M72, or the return from a subprogram with M73, has brought modes back: the plane and the place of
// the coordinates must be what they were.
void Interpreter::keep_contour_in_place(const MoveSink& at, const ModalState& before) {
  constexpr Point kOrigin{0.0, 0.0, 0.0};
  constexpr Point kElsewhere{1.0, 2.0, 3.0};
  ModalState& state = memory_.state;
  const auto same_place = [&](const Point& point) {
    return state.coordinates.to_machine(point) == before.coordinates.to_machine(point);
  };
  if (state.plane == before.plane && same_place(kOrigin) && same_place(kElsewhere)) {
    return;
  }
  state.plane = before.plane;
  state.coordinates = before.coordinates;
  diagnostics_->add({at.source.line, 1, at.source.file}, errors::kNotWhileCompensating,
                    "the saved modes (M70, M73) have another plane or other offsets: they cannot "
                    "come back while cutter compensation is active");
}

}  // namespace kerf::parser
