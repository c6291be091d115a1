#include "parser/curves/curve_block.hpp"

#include <algorithm>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kLargestWeightRatio = 1e6;

bool is_a_point(const NurbsMove& curve) {
  return std::all_of(curve.points.begin(), curve.points.end(), [&](const NurbsPoint& point) {
    return point.position_mm == curve.points.front().position_mm;
  });
}

double weight_ratio(const NurbsMove& curve) {
  const auto [least, most] = std::minmax_element(
      curve.points.begin(), curve.points.end(),
      [](const NurbsPoint& a, const NurbsPoint& b) { return a.weight < b.weight; });
  return most->weight / least->weight;
}

}  // namespace

void append_point(NurbsMove& curve, const NurbsPoint& point, std::uint32_t line) {
  curve.points.push_back(point);
  curve.point_lines.push_back(line);
}

diagnostics::Fault CurveCode::fault(std::uint32_t offset, const diagnostics::ErrorPage& page,
                                    std::initializer_list<std::string_view> parts) const {
  return {offset, joined({name, ": ", joined(parts)}), &page};
}

Expected<double> CurveCode::read_weight(const BlockWords& block, const WeightRule& rule) const {
  const double weight = block.value_or(rule.letter, 1.0);
  if (weight > 0.0) {
    return weight;
  }
  return fail(block.word(rule.letter).offset, *rule.page,
              {"weight ", std::string_view(&rule.letter, 1), " must be greater than 0, found ",
               shortest(weight)});
}

Done check_plane_axes(const BlockWords& block, Plane plane, std::string_view name) {
  const Letters wanted = plane_letters(plane);
  if (const Word* const foreign = leftmost(block, kAxisLetters & ~wanted)) {
    return fail(foreign->offset, errors::kCurveForeignAxis,
                joined({name, ": ", named(letter_of(block, *foreign)), " is not an axis of the ",
                        plane_name(plane), " plane"}));
  }
  if ((block.present & wanted) == wanted || !block.has_any(wanted)) {
    return {};
  }
  const PlaneAxes axes = axes_of(plane);
  const auto low = std::min(axes.first, axes.second);
  const auto high = std::max(axes.first, axes.second);
  return fail(leftmost(block, wanted)->offset, errors::kCurveOneAxis,
              joined({name, ": ", named(axis_letter(low)), " and ", named(axis_letter(high)),
                      " must both be given"}));
}

void push_curve(const RunningBlock& at, ModalState& state, ReadyCurve ready) {
  NurbsMove& curve = ready.curve;
  if (is_a_point(curve)) {
    at.diagnostics.add({curve.point_lines.back(), 1}, errors::kCurveIsAPoint,
                       joined({ready.name, ": the curve has zero length and is left out"}));
    return;
  }
  if (weight_ratio(curve) > kLargestWeightRatio) {
    at.diagnostics.add({curve.point_lines.back(), 1}, errors::kWeightsFarApart,
                       joined({ready.name, ": the weights differ by more than a factor of 1e6"}));
  }
  const Point end = curve.points.back().position_mm;
  Move& move = at.push_move(state);
  move.shape = std::move(curve);
  move.source = ready.source;
  move.feedrate_mm_s = ready.feedrate_mm_s;
  state.position_mm = end;
}

}  // namespace kerf::parser
