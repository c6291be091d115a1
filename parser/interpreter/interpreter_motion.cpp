// Straight moves and arcs.
#include <algorithm>
#include <cmath>

#include "diagnostics/errors/arcs.hpp"
#include "diagnostics/errors/motion.hpp"
#include "diagnostics/errors/offsets.hpp"
#include "diagnostics/errors/shape.hpp"
#include "diagnostics/errors/splines.hpp"
#include "parser/interpreter/arc_words.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG53 = 530;

double distance_mm(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

// Where a message about the motion points: at its code, else at the first word that moves.
std::uint32_t Interpreter::motion_offset() const {
  if (codes_.has(Group::motion)) {
    return code_word(*block_, codes_, Group::motion).offset;
  }
  const Word* const word = leftmost(*block_, axis_letters() | letters('I', 'J', 'K', 'R'));
  return word != nullptr ? word->offset : block_->first_word;
}

void Interpreter::set_motion(Tenths code) {
  if (code == 53 || code == 63) {  // G5.3 and G6.3 leave no mode behind
    code = static_cast<Tenths>(Motion::none);
  }
  const auto motion = static_cast<Motion>(code);
  if (motion != Motion::cubic_spline) {
    state_.spline_handle_mm.reset();
  }
  if (!is_cycle(motion)) {
    state_.cycle.in_series = false;
  }
  if (motion != state_.motion && !(is_cycle(state_.motion) && dialect_ == Dialect::fanuc)) {
    state_.cycle.words = {};
  }
  state_.motion = motion;
}

bool Interpreter::check_machine_coordinates() {
  const Word& code = code_word(*block_, codes_, Group::other);
  const bool by_itself = dialect_ == Dialect::fanuc && !codes_.has(Group::motion);
  if (state_.motion != Motion::rapid && state_.motion != Motion::line && !by_itself) {
    return fail(code.offset, errors::kMachineMotionMode, "G53 can be used only with G0 or G1");
  }
  if (state_.incremental) {
    return fail(code.offset, errors::kMachineIncremental, "G53 needs G90 (G91 is active)");
  }
  if (!block_->has_any(axis_letters())) {
    return fail(code.offset, errors::kMachineWithoutAxis, "G53 needs an axis word");
  }
  return true;
}

// Fanuc's G53 is a rapid whatever the motion mode.
bool Interpreter::rapid_to_words() {
  Point end;
  ExtraWords extra_end;
  if (!resolve_point(curve_block(), state_.position_mm, end, fault_) || !resolve_extra(extra_end)) {
    return false;
  }
  push_rapid(end, extra_end);
  return true;
}

// The block has a motion code, or words that the motion in force takes.
bool Interpreter::asks_for_motion(Letters beside_axes) const {
  return codes_.has(Group::motion) || block_->has_any(axis_letters() | beside_axes);
}

bool Interpreter::move() {
  const bool on_machine = codes_[Group::other] == kG53;
  if (on_machine && !check_machine_coordinates()) {
    return false;
  }
  if (on_machine && state_.motion != Motion::rapid && state_.motion != Motion::line) {
    return rapid_to_words();
  }
  if (codes_.has(Group::other) && !do_once()) {
    return false;
  }
  if (axis_taker_ != Group::count) {
    return true;
  }
  switch (state_.motion) {
    case Motion::rapid:
    case Motion::line:
      return !block_->has_any(axis_letters()) || straight_move();
    case Motion::arc_clockwise:
    case Motion::arc_counterclockwise:
      return !asks_for_motion(letters('I', 'J', 'K', 'R')) || arc_move();
    case Motion::cubic_spline:
      return !asks_for_motion(letters('I', 'J')) || cubic_spline();
    case Motion::quadratic_spline:
      return !asks_for_motion(letters('I', 'J')) || quadratic_spline();
    case Motion::none:
      return codes_[Group::motion] != 53 ||
             fail(motion_offset(), errors::kOpenWithoutCurve, "G5.3 without G5.2");
    default:
      return is_cycle(state_.motion) ? drill_cycle() : probe();
  }
}

// A move of zero length is checked but not delivered.
bool Interpreter::straight_move() {
  Point end;
  if (!resolve_point(curve_block(), state_.position_mm, end, fault_)) {
    return false;
  }
  if (block_->has_any(machine_.extra_axes)) {
    return straight_move_with_extra(end);
  }
  const bool rapid = state_.motion == Motion::rapid;
  double feedrate_mm_s = 0.0;
  double length_mm = 0.0;
  if (state_.feed_mode == FeedMode::inverse_time) {
    length_mm = distance_mm(state_.position_mm, end);
    if (length_mm == 0.0 && compensation_.leaving()) {
      length_mm = compensation_.radius_mm();  // the exit leads from beside the contour on to it
    }
  }
  if (!rapid && !cutting_feedrate(length_mm, feedrate_mm_s)) {
    return false;
  }
  if (end == state_.position_mm && !compensation_.leaving()) {
    return true;
  }
  Move& move = push_move();
  move.shape = LineMove{end};
  move.rapid = rapid;
  move.feedrate_mm_s = feedrate_mm_s;
  state_.position_mm = end;
  return true;
}

bool Interpreter::arc_move() {
  const Point& factor = state_.coordinates.scaling().factor;
  const PlaneAxes plane_axes = axes_of(state_.plane);
  if (std::fabs(factor[plane_axes.first]) != std::fabs(factor[plane_axes.second])) {
    return fail(
        motion_offset(), errors::kArcUnevenlyScaled,
        joined({"an arc in the ", plane_name(state_.plane), " plane cannot be scaled by ",
                shortest(factor[plane_axes.first]), " and ", shortest(factor[plane_axes.second])}));
  }
  if (state_.plane != Plane::xy && state_.coordinates.turned()) {
    return fail(motion_offset(), errors::kTurnedArcPlane,
                joined({"an arc in the ", plane_name(state_.plane),
                        " plane cannot be run while the work offset is turned (G10 L2 R)"}));
  }
  const Letters centre = plane_letters(state_.plane) >> ('X' - 'I');
  if (!block_->has_any(centre | letters('R'))) {
    const PlaneAxes axes = axes_of(state_.plane);
    const char low = std::min(centre_letter(axes.first), centre_letter(axes.second));
    const char high = std::max(centre_letter(axes.first), centre_letter(axes.second));
    const std::string_view plane = plane_name(state_.plane);
    if (!codes_.has(Group::motion)) {
      return fail(motion_offset(), errors::kArcStillActive,
                  joined({"an arc (G", state_.motion == Motion::arc_clockwise ? "2" : "3",
                          " is still active) in the ", plane, " plane needs ", named(low), ", ",
                          named(high), " or R"}));
    }
    const bool bare = !block_->has_any(axis_letters());
    return fail(motion_offset(), errors::kArcWithoutCentre,
                joined({"an arc in the ", plane, " plane needs ", bare ? "an end point and " : "",
                        "a centre (", named(low), ", ", named(high), ") or a radius (R)"}));
  }
  Point end;
  ExtraWords extra_end;
  if (!resolve_point(curve_block(), state_.position_mm, end, fault_) || !resolve_extra(extra_end)) {
    return false;
  }
  ArcMove arc;
  double feedrate_mm_s = 0.0;
  if (!build_arc(*block_, state_, end, arc, fault_) ||
      !cutting_feedrate(arc_length_mm(arc, state_.position_mm), feedrate_mm_s)) {
    return false;
  }
  Move& move = push_move();
  move.shape = arc;
  move.feedrate_mm_s = feedrate_mm_s;
  carry_extra(move, extra_end);
  state_.position_mm = end;
  return true;
}

}  // namespace kerf::parser
