#include "kernel/simulated_answers.hpp"

#include <cmath>
#include <numbers>

#include "machine/touch_surface.hpp"

namespace kerf {

namespace {

using parser::Point;

Point moved(const Point& point, const Point& by, double sign) {
  return {point[0] + sign * by[0], point[1] + sign * by[1], point[2] + sign * by[2]};
}

}  // namespace

Point SimulatedAnswers::tool_offset_mm(std::int32_t tool) const {
  const Tool* found = tools_.find(tool);
  return found != nullptr ? found->offset_mm : Point{};
}

bool SimulatedAnswers::touches(const parser::ProbedWay& way) const {
  if (assumes_contact_) {
    return !way.until_contact;
  }
  return world_.surface &&
         machine::touches(*world_.surface, moved(way.from_mm, tool_offset_mm(way.tool), -1.0));
}

std::optional<Point> SimulatedAnswers::change_of_contact(const parser::ProbedWay& way) const {
  if (assumes_contact_) {
    return way.to_mm;
  }
  if (!world_.surface) {
    return std::nullopt;
  }
  const Point offset_mm = tool_offset_mm(way.tool);
  const Point from = moved(way.from_mm, offset_mm, -1.0);
  const Point to = moved(way.to_mm, offset_mm, -1.0);
  const machine::TipWay of_tip{.from_mm = from, .to_mm = to};
  const auto tip = way.until_contact ? machine::first_contact(*world_.surface, of_tip)
                                     : machine::end_of_contact(*world_.surface, of_tip);
  return tip ? std::optional(moved(*tip, offset_mm, 1.0)) : std::nullopt;
}

double SimulatedAnswers::spindle_time_s(double from_per_min, double to_per_min) const {
  constexpr double kRadPerTurn = 2.0 * std::numbers::pi;
  const double change_rad_s = kRadPerTurn / 60.0 * std::abs(to_per_min - from_per_min);
  return world_.spindle_rad_s2 > 0.0 ? change_rad_s / world_.spindle_rad_s2 : 0.0;
}

}  // namespace kerf
