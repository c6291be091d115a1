#include "parser/curves/splines.hpp"

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

NurbsMove bezier(const std::array<Point, 4>& points, std::size_t count, std::uint32_t line) {
  NurbsMove curve;
  curve.degree = static_cast<int>(count) - 1;
  for (std::size_t i = 0; i < count; ++i) {
    curve.points.push_back({points[i], 1.0});
  }
  curve.knots.assign(count, 0.0);
  curve.knots.insert(curve.knots.end(), count, 1.0);
  curve.point_lines.assign(count, line);
  curve.knot_lines.assign(2 * count, line);
  return curve;
}

Point moved(const Point& from, double x_mm, double y_mm) {
  return {from[0] + x_mm, from[1] + y_mm, from[2]};
}

// Fanuc writes its high-speed modes as G05 P10000, G05 P0 and G05.1 Q1: no axes, one parameter.
bool is_high_speed_mode(const RunningBlock& at) {
  const Letters parameters = letters('P', 'Q', 'I', 'J') | at.axis_letters();
  const Letters given = at.block.present & parameters;
  return at.codes.has(Group::motion) && (given == letters('P') || given == letters('Q'));
}

// Two words of the program as a distance along the machine's X and Y.
std::array<double, 2> handle_mm(const ModalState& state, double x_word, double y_word) {
  const double unit = mm_per_unit(state.units);
  const Point along{x_word * unit, y_word * unit, 0.0};
  const Point turned = state.coordinates.turned_to_machine(along);
  return {turned[0], turned[1]};
}

Done check_axes(const RunningBlock& at, const ModalState& state, std::string_view name) {
  if (state.plane != Plane::xy) {
    return fail(at.motion_offset(), errors::kSplineOutsideXy,
                joined({name, " works only in the XY plane (G17)"}));
  }
  if (at.block.has('Z')) {
    return fail(at.block.word('Z').offset, errors::kSplineWithZ,
                joined({"Z is not used by ", name}));
  }
  if (Done fine = refuse_auxiliary(at, joined({"with ", name})); !fine) {
    return fine;
  }
  if (!at.block.has_any(letters('X', 'Y'))) {
    return fail(at.motion_offset(), errors::kSplineWithoutEnd,
                joined({name, " needs an end point (X, Y)"}));
  }
  if (state.feed_mode == FeedMode::inverse_time) {
    return fail(at.motion_offset(), errors::kSplineInverseTime,
                joined({name, " cannot be used with G93"}));
  }
  return {};
}

}  // namespace

Expected<std::optional<Spline>> cubic_spline(const RunningBlock& at, ModalState& state) {
  const BlockWords& block = at.block;
  if (is_high_speed_mode(at)) {
    at.warn(at.motion_offset(), errors::kHighSpeedMode,
            joined({upper(block.text(code_word(block, at.codes, Group::motion))), " ",
                    upper(block.text(*leftmost(block, letters('P', 'Q')))),
                    " (high-speed mode) is ignored"}));
    set_motion(at, state, static_cast<Tenths>(Motion::none));
    return std::nullopt;
  }
  if (Done fine = check_axes(at, state, "G5"); !fine) {
    return fault_of(fine);
  }
  if (!block.has('P') || !block.has('Q')) {
    return fail(at.motion_offset(), errors::kSplineWithoutHandle, "G5 needs P and Q");
  }
  if (block.has('I') != block.has('J')) {
    return fail(leftmost(block, letters('I', 'J'))->offset, errors::kHalfSplineStart,
                "G5: I and J must both be given or both left out");
  }
  if (!block.has('I') && !state.spline_handle_mm) {
    return fail(at.motion_offset(), errors::kFirstSplineWithoutStart,
                "G5: the first spline of a series needs I and J");
  }
  Expected<Point> end = resolve_point(at, state, state.position_mm);
  if (!end) {
    return fault_of(end);
  }
  const auto first = block.has('I')
                         ? handle_mm(state, block.value('I'), block.value('J'))
                         : std::array{-(*state.spline_handle_mm)[0], -(*state.spline_handle_mm)[1]};
  const auto second = handle_mm(state, block.value('P'), block.value('Q'));
  const Point& start = state.position_mm;
  const std::array points{start, moved(start, first[0], first[1]),
                          moved(*end, second[0], second[1]), *end};
  return Spline{bezier(points, 4, at.source.line), second};
}

Expected<std::optional<Spline>> quadratic_spline(const RunningBlock& at, ModalState& state) {
  const BlockWords& block = at.block;
  if (is_high_speed_mode(at)) {
    at.warn(at.motion_offset(), errors::kHighSpeedMode,
            joined({"G5.1 ", upper(block.text(*leftmost(block, letters('P', 'Q')))),
                    " (contour control) is ignored"}));
    set_motion(at, state, static_cast<Tenths>(Motion::none));
    return std::nullopt;
  }
  if (Done fine = check_axes(at, state, "G5.1"); !fine) {
    return fault_of(fine);
  }
  if (block.has('Q')) {
    return fail(block.word('Q').offset, errors::kSplineUnusedQ,
                "Q is not used by G5.1 with an end point");
  }
  if (!block.has_any(letters('I', 'J'))) {
    return fail(at.motion_offset(), errors::kQuadraticWithoutHandle, "G5.1 needs I or J");
  }
  Expected<Point> end = resolve_point(at, state, state.position_mm);
  if (!end) {
    return fault_of(end);
  }
  const Point& start = state.position_mm;
  const auto offset = handle_mm(state, block.value_or('I', 0.0), block.value_or('J', 0.0));
  const Point handle = moved(start, offset[0], offset[1]);
  return Spline{bezier({start, handle, *end, *end}, 3, at.source.line), std::nullopt};
}

}  // namespace kerf::parser
