// The motion of a block along lines and arcs.
#include <algorithm>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/interpreter/arc_words.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/offsets/reference_points.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG53 = 530;

double distance_mm(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The block has a motion code, or words that the motion in force takes.
bool asks_for_motion(const RunningBlock& at, Letters beside_axes) {
  return at.codes.has(Group::motion) || at.block.has_any(at.axis_letters() | beside_axes);
}

Done check_machine_coordinates(const RunningBlock& at, const ModalState& state) {
  const Word& code = at.code_word(Group::other);
  const bool by_itself = at.rules.machine_rapid && !at.codes.has(Group::motion);
  if (state.motion != Motion::rapid && state.motion != Motion::line && !by_itself) {
    return fail(code.offset, errors::kMachineMotionMode, "G53 can be used only with G0 or G1");
  }
  if (state.incremental) {
    return fail(code.offset, errors::kMachineIncremental, "G53 needs G90 (G91 is active)");
  }
  if (!at.block.has_any(at.axis_letters())) {
    return fail(code.offset, errors::kMachineWithoutAxis, "G53 needs an axis word");
  }
  return {};
}

Done check_arc(const RunningBlock& at, const ModalState& state) {
  const Point& factor = state.coordinates.scaling().factor;
  const PlaneAxes plane_axes = axes_of(state.plane);
  if (std::fabs(factor[plane_axes.first]) != std::fabs(factor[plane_axes.second])) {
    return fail(
        at.motion_offset(), errors::kArcUnevenlyScaled,
        joined({"an arc in the ", plane_name(state.plane), " plane cannot be scaled by ",
                shortest(factor[plane_axes.first]), " and ", shortest(factor[plane_axes.second])}));
  }
  if (state.plane != Plane::xy && state.coordinates.turned()) {
    return fail(at.motion_offset(), errors::kTurnedArcPlane,
                joined({"an arc in the ", plane_name(state.plane),
                        " plane cannot be run while the work offset is turned (G10 L2 R)"}));
  }
  const Letters centre = plane_letters(state.plane) >> ('X' - 'I');
  if (!at.block.has_any(centre | letters('R'))) {
    const PlaneAxes axes = axes_of(state.plane);
    const char low = std::min(centre_letter(axes.first), centre_letter(axes.second));
    const char high = std::max(centre_letter(axes.first), centre_letter(axes.second));
    const std::string_view plane = plane_name(state.plane);
    if (!at.codes.has(Group::motion)) {
      return fail(at.motion_offset(), errors::kArcStillActive,
                  joined({"an arc (G", state.motion == Motion::arc_clockwise ? "2" : "3",
                          " is still active) in the ", plane, " plane needs ", named(low), ", ",
                          named(high), " or R"}));
    }
    const bool bare = !at.block.has_any(at.axis_letters());
    return fail(at.motion_offset(), errors::kArcWithoutCentre,
                joined({"an arc in the ", plane, " plane needs ", bare ? "an end point and " : "",
                        "a centre (", named(low), ", ", named(high), ") or a radius (R)"}));
  }
  return {};
}

}  // namespace

Done Interpreter::move(const RunningBlock& at, Group axis_taker) {
  const ModalState& state = memory_.state;
  const bool on_machine = at.codes[Group::other] == kG53;
  if (on_machine) {
    if (Done fine = check_machine_coordinates(at, state); !fine) {
      return fine;
    }
  }
  if (on_machine && state.motion != Motion::rapid && state.motion != Motion::line) {
    return rapid_to_words(at);
  }
  if (at.codes.has(Group::other)) {
    if (Done done = do_once(at); !done) {
      return done;
    }
  }
  return axis_taker == Group::count ? do_motion(at) : Done();
}

// The motion in force.
inline Done Interpreter::do_motion(const RunningBlock& at) {
  const ModalState& state = memory_.state;
  switch (state.motion) {
    case Motion::rapid:
    case Motion::line:
      return at.block.has_any(at.axis_letters()) ? straight_move(at) : Done();
    case Motion::arc_clockwise:
    case Motion::arc_counterclockwise:
      return asks_for_motion(at, letters('I', 'J', 'K', 'R')) ? arc_move(at) : Done();
    case Motion::cubic_spline:
    case Motion::quadratic_spline:
      return asks_for_motion(at, letters('I', 'J')) ? spline(at) : Done();
    case Motion::none:
      if (at.codes[Group::motion] != 53) {
        return {};
      }
      return fail(at.motion_offset(), errors::kOpenWithoutCurve, "G5.3 without G5.2");
    default:
      return is_cycle(state.motion) ? drill(at) : probe(at);
  }
}

// Fanuc's G53 is a rapid whatever the motion mode.
Done Interpreter::rapid_to_words(const RunningBlock& at) {
  ModalState& state = memory_.state;
  Expected<Point> end = resolve_point(at, state, state.position_mm);
  if (!end) {
    return fault_of(end);
  }
  Expected<AuxiliaryWords> auxiliary_end = resolve_auxiliary(at, state, compensation_.phase());
  if (!auxiliary_end) {
    return fault_of(auxiliary_end);
  }
  push_rapid(at, state, *end, *auxiliary_end);
  return {};
}

// A move of zero length is checked but not delivered.
Done Interpreter::straight_move(const RunningBlock& at) {
  ModalState& state = memory_.state;
  Expected<Point> end = resolve_point(at, state, state.position_mm);
  if (!end) {
    return fault_of(end);
  }
  if (at.block.has_any(at.auxiliary_axes)) {
    return straight_move_with_auxiliary(at, *end);
  }
  if (state.motion == Motion::rapid) {
    push_line(at, {*end, true, 0.0});
    return {};
  }
  double length_mm = 0.0;
  if (state.feed_mode == FeedMode::inverse_time) {
    length_mm = distance_mm(state.position_mm, *end);
    if (length_mm == 0.0 && compensation_.leaving()) {
      length_mm = compensation_.radius_mm();  // the exit leads from beside the contour on to it
    }
  }
  Expected<double> feedrate = feed_.cutting(at, state, length_mm);
  if (!feedrate) {
    return fault_of(feedrate);
  }
  push_line(at, {*end, false, *feedrate});
  return {};
}

inline void Interpreter::push_line(const RunningBlock& at, const Straight& line) {
  ModalState& state = memory_.state;
  if (line.end_mm == state.position_mm && !compensation_.leaving()) {
    return;
  }
  Move& move = at.push_move(state);
  move.shape = LineMove{line.end_mm};
  move.rapid = line.rapid;
  move.feedrate_mm_s = line.feedrate_mm_s;
  state.position_mm = line.end_mm;
}

// F is along X, Y and Z where one of them moves.
Done Interpreter::straight_move_with_auxiliary(const RunningBlock& at, const Point& end_mm) {
  ModalState& state = memory_.state;
  Expected<AuxiliaryWords> auxiliary_end = resolve_auxiliary(at, state, compensation_.phase());
  if (!auxiliary_end) {
    return fault_of(auxiliary_end);
  }
  const double way_mm = distance_mm(end_mm, state.position_mm);
  const AuxiliaryMove auxiliary = auxiliary_move(state.auxiliary_deg_mm, *auxiliary_end);
  const bool alone = auxiliary.moves() && way_mm < kShortestWay_mm;
  const bool rapid = state.motion == Motion::rapid;
  Expected<double> feedrate = rapid   ? 0.0
                              : alone ? feed_.auxiliary_axes(at, state, auxiliary)
                                      : feed_.cutting(at, state, way_mm);
  if (!feedrate) {
    return fault_of(feedrate);
  }
  if (end_mm == state.position_mm && !auxiliary.moves()) {
    return {};
  }
  Move& move = at.push_move(state);
  move.shape = LineMove{end_mm};
  move.rapid = rapid;
  move.feedrate_mm_s = *feedrate;
  carry_auxiliary(at, state, move, *auxiliary_end);
  state.position_mm = end_mm;
  return {};
}

Done Interpreter::arc_move(const RunningBlock& at) {
  ModalState& state = memory_.state;
  if (Done fine = check_arc(at, state); !fine) {
    return fine;
  }
  Expected<Point> end = resolve_point(at, state, state.position_mm);
  if (!end) {
    return fault_of(end);
  }
  Expected<AuxiliaryWords> auxiliary_end = resolve_auxiliary(at, state, compensation_.phase());
  if (!auxiliary_end) {
    return fault_of(auxiliary_end);
  }
  Expected<ArcMove> arc = build_arc(at.block, state, *end);
  if (!arc) {
    return fault_of(arc);
  }
  Expected<double> feedrate = feed_.cutting(at, state, arc_length_mm(*arc, state.position_mm));
  if (!feedrate) {
    return fault_of(feedrate);
  }
  Move& move = at.push_move(state);
  move.shape = *arc;
  move.feedrate_mm_s = *feedrate;
  carry_auxiliary(at, state, move, *auxiliary_end);
  state.position_mm = arc->end_mm;
  return {};
}

}  // namespace kerf::parser
