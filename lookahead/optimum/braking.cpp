#include "lookahead/optimum/braking.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "lookahead/optimum/stop_search.hpp"
#include "profiles/s_curve_stop.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kRounded = 1.0 + 1e-9;

std::optional<std::vector<BrakingPart>> stop_on_line(const BrakingFrom& from,
                                                     const PlanLimits& limits) {
  const Block& block = *from.blocks.front();
  const double clear_mm = junction_zone_mm(from.state, limits);
  if (!std::holds_alternative<curves::Line>(block.curve) ||
      (from.before != nullptr && from.s_mm < clear_mm)) {
    return std::nullopt;
  }
  // A trapezoid turns its acceleration off at once; no jerk within the limits can.
  const double a = std::max(from.state.a_mm_s2, 0.0);
  if (from.state.v_mm_s + 0.5 * a * a / block.limits.ramp.jerk_mm_s3 >
      kRounded * block.limits.feedrate_mm_s) {
    return std::nullopt;
  }
  const auto stop = profiles::s_curve_stop(
      {.v_mm_s = from.state.v_mm_s, .a_mm_s2 = from.state.a_mm_s2}, block.limits.ramp);
  if (!stop || from.s_mm + stop->length_mm() > block.length_mm - kAtBlockEnd_mm) {
    return std::nullopt;
  }
  return parts_of(*stop, block, from.s_mm);
}

}  // namespace

std::vector<BrakingPart> parts_of(const profiles::SCurveStop& stop, const Block& block,
                                  double s_mm) {
  std::vector<BrakingPart> parts;
  for (const auto& [law, limit] : {std::pair{&stop.falling, block.limits.from.jerk},
                                   std::pair{&stop.steady, block.limits.from.acceleration},
                                   std::pair{&stop.landing, block.limits.from.jerk}}) {
    if (law->duration_s() > 0.0) {
      s_mm += law->length_mm();
      parts.push_back({.law = *law, .s_end_mm = s_mm, .limit = limit});
    }
  }
  return parts;
}

std::optional<std::vector<BrakingPart>> find_braking(const BrakingFrom& from,
                                                     const PlanLimits& limits) {
  if (from.blocks.empty()) {
    return std::nullopt;
  }
  auto parts = stop_on_line(from, limits);
  return parts ? std::move(parts) : StopSearch(from, limits).shortest();
}

std::optional<std::vector<BrakingPart>> find_any_braking(const BrakingFrom& from,
                                                         const PlanLimits& limits,
                                                         StopDistance distance) {
  if (from.blocks.empty()) {
    return std::nullopt;
  }
  auto parts = stop_on_line(from, limits);
  return parts ? std::move(parts) : StopSearch(from, limits).any(distance);
}

}  // namespace kerf::lookahead
