#include "parser/curves/curve_block.hpp"

#include <algorithm>

#include "diagnostics/errors/curves.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

void append_point(NurbsMove& curve, const NurbsPoint& point, std::uint32_t line) {
  curve.points.push_back(point);
  curve.point_lines.push_back(line);
}

bool CurveCode::fail(diagnostics::Fault& fault, std::uint32_t offset,
                     const diagnostics::ErrorPage& page,
                     std::initializer_list<std::string_view> parts) const {
  fault = {offset, joined({name, ": ", joined(parts)}), &page};
  return false;
}

bool CurveCode::read_weight(const Block& block, const WeightRule& rule, double& weight,
                            diagnostics::Fault& fault) const {
  weight = block.value_or(rule.letter, 1.0);
  if (weight > 0.0) {
    return true;
  }
  return fail(fault, block.word(rule.letter).offset, *rule.page,
              {"weight ", std::string_view(&rule.letter, 1), " must be greater than 0, found ",
               shortest(weight)});
}

bool check_plane_axes(const CurveBlock& at, std::string_view name, diagnostics::Fault& fault) {
  const Plane plane = at.state.plane;
  const Letters wanted = plane_letters(plane);
  const Block& block = at.block;
  if (const Word* const foreign = leftmost(block, kAxisLetters & ~wanted)) {
    fault = {foreign->offset,
             joined({name, ": ", named(letter_of(block, *foreign)), " is not an axis of the ",
                     plane_name(plane), " plane"}),
             &errors::kCurveForeignAxis};
    return false;
  }
  if ((block.present & wanted) == wanted || !block.has_any(wanted)) {
    return true;
  }
  const PlaneAxes axes = axes_of(plane);
  const auto low = std::min(axes.first, axes.second);
  const auto high = std::max(axes.first, axes.second);
  fault = {leftmost(block, wanted)->offset,
           joined({name, ": ", named(axis_letter(low)), " and ", named(axis_letter(high)),
                   " must both be given"}),
           &errors::kCurveOneAxis};
  return false;
}

bool is_a_point(const NurbsMove& curve) {
  return std::all_of(curve.points.begin(), curve.points.end(), [&](const NurbsPoint& point) {
    return point.position_mm == curve.points.front().position_mm;
  });
}

}  // namespace kerf::parser
