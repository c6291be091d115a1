// G5 and G5.1: one Bezier curve per block.
#include "diagnostics/errors/splines.hpp"
#include "parser/interpreter/interpreter.hpp"
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

}  // namespace

// Fanuc writes its high-speed modes as G05 P10000, G05 P0 and G05.1 Q1: no axes, one parameter.
bool Interpreter::is_high_speed_mode() const {
  const Letters parameters = letters('P', 'Q', 'I', 'J') | axis_letters();
  const Letters given = block_->present & parameters;
  return codes_.has(Group::motion) && (given == letters('P') || given == letters('Q'));
}

// Two words of the program as a distance along the machine's X and Y.
std::array<double, 2> Interpreter::handle_mm(double x_word, double y_word) const {
  const double unit = mm_per_unit(state_.units);
  const Point along{x_word * unit, y_word * unit, 0.0};
  const Point turned = state_.coordinates.turned_to_machine(along);
  return {turned[0], turned[1]};
}

bool Interpreter::check_spline_axes(std::string_view name) {
  if (state_.plane != Plane::xy) {
    return fail(motion_offset(), errors::kSplineOutsideXy,
                joined({name, " works only in the XY plane (G17)"}));
  }
  if (block_->has('Z')) {
    return fail(block_->word('Z').offset, errors::kSplineWithZ,
                joined({"Z is not used by ", name}));
  }
  if (!refuse_extra(joined({"with ", name}))) {
    return false;
  }
  if (!block_->has_any(letters('X', 'Y'))) {
    return fail(motion_offset(), errors::kSplineWithoutEnd,
                joined({name, " needs an end point (X, Y)"}));
  }
  if (state_.feed_mode == FeedMode::inverse_time) {
    return fail(motion_offset(), errors::kSplineInverseTime,
                joined({name, " cannot be used with G93"}));
  }
  return true;
}

bool Interpreter::deliver_spline(NurbsMove curve, std::string_view name) {
  curve_source_ = {line_, block_->first_word + 1, file_};
  return cutting_feedrate(0.0, curve_feedrate_mm_s_) && deliver_curve(std::move(curve), name);
}

bool Interpreter::cubic_spline() {
  const Block& block = *block_;
  if (is_high_speed_mode()) {
    warn(motion_offset(), errors::kHighSpeedMode,
         joined({upper(block.text(code_word(block, codes_, Group::motion))), " ",
                 upper(block.text(*leftmost(block, letters('P', 'Q')))),
                 " (high-speed mode) is ignored"}));
    set_motion(static_cast<Tenths>(Motion::none));
    return true;
  }
  if (!check_spline_axes("G5")) {
    return false;
  }
  if (!block.has('P') || !block.has('Q')) {
    return fail(motion_offset(), errors::kSplineWithoutHandle, "G5 needs P and Q");
  }
  if (block.has('I') != block.has('J')) {
    return fail(leftmost(block, letters('I', 'J'))->offset, errors::kHalfSplineStart,
                "G5: I and J must both be given or both left out");
  }
  if (!block.has('I') && !state_.spline_handle_mm) {
    return fail(motion_offset(), errors::kFirstSplineWithoutStart,
                "G5: the first spline of a series needs I and J");
  }
  Point end;
  if (!resolve_point(curve_block(), state_.position_mm, end, fault_)) {
    return false;
  }
  const auto first =
      block.has('I') ? handle_mm(block.value('I'), block.value('J'))
                     : std::array{-(*state_.spline_handle_mm)[0], -(*state_.spline_handle_mm)[1]};
  const auto second = handle_mm(block.value('P'), block.value('Q'));
  const Point& start = state_.position_mm;
  const std::array points{start, moved(start, first[0], first[1]), moved(end, second[0], second[1]),
                          end};
  if (!deliver_spline(bezier(points, 4, line_), "G5")) {
    return false;
  }
  state_.spline_handle_mm = second;
  return true;
}

bool Interpreter::quadratic_spline() {
  const Block& block = *block_;
  if (is_high_speed_mode()) {
    warn(motion_offset(), errors::kHighSpeedMode,
         joined({"G5.1 ", upper(block.text(*leftmost(block, letters('P', 'Q')))),
                 " (contour control) is ignored"}));
    set_motion(static_cast<Tenths>(Motion::none));
    return true;
  }
  if (!check_spline_axes("G5.1")) {
    return false;
  }
  if (block.has('Q')) {
    return fail(block.word('Q').offset, errors::kSplineUnusedQ,
                "Q is not used by G5.1 with an end point");
  }
  if (!block.has_any(letters('I', 'J'))) {
    return fail(motion_offset(), errors::kQuadraticWithoutHandle, "G5.1 needs I or J");
  }
  Point end;
  if (!resolve_point(curve_block(), state_.position_mm, end, fault_)) {
    return false;
  }
  const Point& start = state_.position_mm;
  const auto offset = handle_mm(block.value_or('I', 0.0), block.value_or('J', 0.0));
  const Point handle = moved(start, offset[0], offset[1]);
  return deliver_spline(bezier({start, handle, end, end}, 3, line_), "G5.1");
}

}  // namespace kerf::parser
