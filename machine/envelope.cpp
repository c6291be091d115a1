#include "machine/envelope.hpp"

#include <charconv>
#include <cmath>
#include <cstddef>
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

// Six digits, whatever the locale.
std::string text_of(double number) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                 std::chars_format::general, 6);
  return {buffer.data(), end.ptr};
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
  const std::string name(1, "xyz"[excess.axis]);
  if (!std::isfinite(excess.by_mm)) {
    return name + " is not a finite number";
  }
  return name + " goes " + text_of(excess.by_mm) + " mm beyond its " +
         (excess.above ? "upper" : "lower") + " limit of " + text_of(excess.limit_mm) + " mm";
}

}  // namespace kerf::machine
