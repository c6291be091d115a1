#include "parser/cycles/probe.hpp"

#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

bool leaves_contact(Motion motion) {
  return motion == Motion::probe_off || motion == Motion::probe_off_if;
}

bool must_succeed(Motion motion) {
  return motion == Motion::probe_on || motion == Motion::probe_off;
}

// The tool comes to rest where it touches: what a probe is for.
void push_probe_move(const RunningBlock& at, ModalState& state, const Point& end_mm,
                     double feedrate_mm_s) {
  if (end_mm == state.position_mm) {
    return;
  }
  Move& move = at.push_move(state);
  move.probes = true;
  move.mode = PathMode::exact_stop;
  move.blend_tolerance_mm = 0.0;
  move.merge_tolerance_mm = 0.0;
  move.shape = LineMove{end_mm};
  move.feedrate_mm_s = feedrate_mm_s;
  state.position_mm = end_mm;
}

}  // namespace

Expected<std::optional<ProbeWay>> read_probe(const RunningBlock& at, const ModalState& state) {
  if (Done fine = refuse_auxiliary(at, joined({"with ", motion_name(state)})); !fine) {
    return fault_of(fine);
  }
  if (!at.block.has_any(kAxisLetters)) {
    if (!at.codes.has(Group::motion)) {
      return std::nullopt;
    }
    return fail(at.motion_offset(), errors::kProbeWithoutAxis,
                joined({motion_name(state), " needs at least one axis word"}));
  }
  Expected<Point> end = resolve_point(at, state, state.position_mm);
  if (!end) {
    return fault_of(end);
  }
  const Point way = difference(*end, state.position_mm);
  const double length_mm = std::hypot(way[0], way[1], way[2]);
  if (length_mm == 0.0) {
    return fail(at.motion_offset(), errors::kProbeWithoutWay,
                joined({motion_name(state), ": the tool already is where the block leads"}));
  }
  return ProbeWay{*end, length_mm};
}

Done run_probe(const RunningBlock& at, ModalState& state, const MachineSource& machine,
               const ProbeMove& asked) {
  const bool off = leaves_contact(state.motion);
  if (machine.asks_in(at.block_number)) {
    const MachineQuestion question{.kind = off ? MachineQuestion::Kind::contact_end
                                               : MachineQuestion::Kind::contact};
    at.push_event(state, {.kind = EventKind::probe_begin, .question = question});
    push_probe_move(at, state, asked.end_mm, asked.feedrate_mm_s);
    at.push_event(state, {.kind = EventKind::ask_machine, .question = question});
    return {};
  }
  const AssumedMachine* assumed = machine.assumed.get();
  const ProbedWay way{.from_mm = state.position_mm,
                      .to_mm = asked.end_mm,
                      .tool = state.loaded_tool,
                      .until_contact = !off};
  MachineAnswer answer{.at_start = (assumed != nullptr && assumed->touches(way)) != off};
  answer.rest_mm = state.position_mm;
  if (!answer.at_start) {
    const auto contact = assumed != nullptr ? assumed->change_of_contact(way) : std::nullopt;
    answer.found = contact.has_value();
    answer.place_mm = answer.rest_mm = contact.value_or(asked.end_mm);
    push_probe_move(at, state, answer.rest_mm, asked.feedrate_mm_s);
  }
  const bool has_surface = assumed != nullptr && assumed->has_surface();
  return take_probe_answer({.motion = state.motion,
                            .offset = at.motion_offset(),
                            .why = has_surface ? "" : " (the machine file has no [probe])"},
                           answer, state);
}

Done take_probe_answer(const AskedProbe& asked, const MachineAnswer& answer, ModalState& state) {
  state.position_mm = answer.rest_mm;
  const bool off = leaves_contact(asked.motion);
  const std::string name = motion_name(asked.motion);
  if (answer.at_start) {
    return fail(asked.offset, off ? errors::kProbeNotTouching : errors::kProbeTouching,
                joined({name, off ? " begins without contact" : " begins in contact", asked.why}));
  }
  state.probe = {state.coordinates.to_program(answer.place_mm),
                 state.coordinates.auxiliary_to_program(state.auxiliary_deg_mm), answer.found};
  if (!answer.found && must_succeed(asked.motion)) {
    return fail(asked.offset, errors::kProbeInVain,
                joined({name, off ? " ended in contact" : " met nothing", asked.why}));
  }
  return {};
}

}  // namespace kerf::parser
