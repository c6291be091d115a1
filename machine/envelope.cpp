#include "machine/envelope.hpp"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>

namespace kerf::machine {
namespace {

// Beyond max_mm where above, else below min_mm. Not a number counts as infinitely far outside.
TravelExcess excess_of(const Travel& travel, double coordinate_mm, bool above) {
  const double limit_mm = above ? travel.max_mm : travel.min_mm;
  if (std::isnan(coordinate_mm)) {
    return {.above = above, .limit_mm = limit_mm, .by_mm = std::numeric_limits<double>::infinity()};
  }
  const bool beyond = above ? coordinate_mm > limit_mm : coordinate_mm < limit_mm;
  return {.above = above,
          .limit_mm = limit_mm,
          .by_mm = beyond ? std::abs(coordinate_mm - limit_mm) : 0.0};
}

}  // namespace

Envelope envelope_of(const TableSettings& settings) noexcept {
  return {settings.axes[0].travel, settings.axes[1].travel, settings.axes[2].travel};
}

std::optional<TravelExcess> outside_travel(const Envelope& envelope,
                                           const curves::Extents& box) noexcept {
  TravelExcess worst{.by_mm = kTravelToleranceMm};
  bool outside = false;
  for (std::size_t axis = 0; axis < envelope.size(); ++axis) {
    for (const bool above : {false, true}) {
      TravelExcess excess =
          excess_of(envelope[axis], above ? box.max_mm[axis] : box.min_mm[axis], above);
      if (excess.by_mm > worst.by_mm) {
        excess.axis = static_cast<std::int8_t>(axis);
        worst = excess;
        outside = true;
      }
    }
  }
  return outside ? std::optional(worst) : std::nullopt;
}

std::optional<TravelExcess> outside_travel(const Envelope& envelope,
                                           const curves::Position& point) noexcept {
  return outside_travel(envelope, curves::Extents{.min_mm = point, .max_mm = point});
}

std::string describe(const TravelExcess& excess) {
  const char name = "xyz"[excess.axis];
  char text[96];
  if (!std::isfinite(excess.by_mm)) {
    std::snprintf(text, sizeof text, "%c is not a finite number", name);
  } else {
    std::snprintf(text, sizeof text, "%c goes %.6g mm beyond its %s limit of %.9g mm", name,
                  excess.by_mm, excess.above ? "upper" : "lower", excess.limit_mm);
  }
  return text;
}

}  // namespace kerf::machine
