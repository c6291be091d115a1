// G38.2 to G38.5: straight moves that end where the tool touches the simulated table's surface, or
// leaves it.
#include <cmath>

#include "diagnostics/errors/probing.hpp"
#include "parser/interpreter/interpreter.hpp"
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

}  // namespace

bool Interpreter::probe() {
  if (!refuse_extra(joined({"with ", motion_name()}))) {
    return false;
  }
  if (!block_->has_any(kAxisLetters)) {
    return !codes_.has(Group::motion) ||
           fail(motion_offset(), errors::kProbeWithoutAxis,
                joined({motion_name(), " needs at least one axis word"}));
  }
  Point end;
  if (!resolve_point(curve_block(), state_.position_mm, end, fault_)) {
    return false;
  }
  const Point way = difference(end, state_.position_mm);
  const double length_mm = std::hypot(way[0], way[1], way[2]);
  if (length_mm == 0.0) {
    return fail(motion_offset(), errors::kProbeWithoutWay,
                joined({motion_name(), ": the tool already is where the block leads"}));
  }
  double feedrate_mm_s = 0.0;
  if (!cutting_feedrate(length_mm, feedrate_mm_s)) {
    return false;
  }
  const bool found = find_contact(end);
  if (fault_.page != nullptr) {
    return false;
  }
  push_probe_move(end, feedrate_mm_s);
  state_.probe = {state_.coordinates.to_program(end),
                  state_.coordinates.extra_to_program(state_.extra_deg_mm), found};
  if (!found && must_succeed(state_.motion)) {
    return fail(
        motion_offset(), errors::kProbeInVain,
        joined({motion_name(), leaves_contact(state_.motion) ? " ended in contact" : " met nothing",
                machine_.touch_box ? "" : " (the machine file has no [probe])"}));
  }
  return true;
}

// Shortens the way to where contact changes. False where it does not, or with the fault set.
bool Interpreter::find_contact(Point& end_mm) {
  fault_ = {};
  const bool off = leaves_contact(state_.motion);
  const Point& tool = state_.coordinates.tool_mm();
  const Point from = difference(state_.position_mm, tool);
  const bool touching = machine_.touch_box && touches(*machine_.touch_box, from);
  if (touching != off) {
    return fail(motion_offset(), off ? errors::kProbeNotTouching : errors::kProbeTouching,
                joined({motion_name(), off ? " begins without contact" : " begins in contact",
                        off && !machine_.touch_box ? " (the machine file has no [probe])" : ""}));
  }
  if (!machine_.touch_box) {
    return false;
  }
  const Point to = difference(end_mm, tool);
  const std::optional<Point> contact = off ? last_contact(*machine_.touch_box, from, to)
                                           : first_contact(*machine_.touch_box, from, to);
  if (contact) {
    end_mm = sum(*contact, tool);
  }
  return contact.has_value();
}

// The tool comes to rest where it touches: what a probe is for.
void Interpreter::push_probe_move(const Point& end_mm, double feedrate_mm_s) {
  if (end_mm == state_.position_mm) {
    return;
  }
  Move& move = push_move();
  move.mode = PathMode::exact_stop;
  move.blend_tolerance_mm = 0.0;
  move.merge_tolerance_mm = 0.0;
  move.shape = LineMove{end_mm};
  move.feedrate_mm_s = feedrate_mm_s;
  state_.position_mm = end_mm;
}

}  // namespace kerf::parser
