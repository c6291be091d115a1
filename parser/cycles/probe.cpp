#include "parser/cycles/probe.hpp"

#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/modal/touch_box.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

Point sum(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

bool leaves_contact(Motion motion) {
  return motion == Motion::probe_off || motion == Motion::probe_off_if;
}

bool must_succeed(Motion motion) {
  return motion == Motion::probe_on || motion == Motion::probe_off;
}

// Where contact changes on the way to `end_mm`; nothing where it does not.
Expected<std::optional<Point>> find_contact(const RunningBlock& at, const ModalState& state,
                                            const std::optional<TouchBox>& box,
                                            const Point& end_mm) {
  const bool off = leaves_contact(state.motion);
  const Point& tool = state.coordinates.tool_mm();
  const Point from = difference(state.position_mm, tool);
  const bool touching = box && touches(*box, from);
  if (touching != off) {
    return fail(at.motion_offset(), off ? errors::kProbeNotTouching : errors::kProbeTouching,
                joined({motion_name(state), off ? " begins without contact" : " begins in contact",
                        off && !box ? " (the machine file has no [probe])" : ""}));
  }
  if (!box) {
    return std::nullopt;
  }
  const Point to = difference(end_mm, tool);
  const std::optional<Point> contact =
      off ? last_contact(*box, from, to) : first_contact(*box, from, to);
  return contact ? std::optional(sum(*contact, tool)) : std::nullopt;
}

// The tool comes to rest where it touches: what a probe is for.
void push_probe_move(const RunningBlock& at, ModalState& state, const Point& end_mm,
                     double feedrate_mm_s) {
  if (end_mm == state.position_mm) {
    return;
  }
  Move& move = at.push_move(state);
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

Done run_probe(const RunningBlock& at, ModalState& state, const std::optional<TouchBox>& box,
               const ProbeMove& asked) {
  Expected<std::optional<Point>> found = find_contact(at, state, box, asked.end_mm);
  if (!found) {
    return fault_of(found);
  }
  const Point end = found->value_or(asked.end_mm);
  push_probe_move(at, state, end, asked.feedrate_mm_s);
  state.probe = {state.coordinates.to_program(end),
                 state.coordinates.auxiliary_to_program(state.auxiliary_deg_mm),
                 found->has_value()};
  if (!*found && must_succeed(state.motion)) {
    return fail(at.motion_offset(), errors::kProbeInVain,
                joined({motion_name(state),
                        leaves_contact(state.motion) ? " ended in contact" : " met nothing",
                        box ? "" : " (the machine file has no [probe])"}));
  }
  return {};
}

}  // namespace kerf::parser
