#include "machine/envelope.hpp"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>

namespace kerf::machine {
namespace {

constexpr double kDegreesPerRadian = 180.0 / 3.14159265358979323846;

struct Range {
  double low = 0.0;
  double high = 0.0;
};

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

// The worse of `worst` and what of the range lies outside the travel of one more axis.
TravelExcess worse(const TravelExcess& worst, std::size_t axis, const Travel& travel,
                   const Range& range) {
  TravelExcess result = worst;
  for (const bool above : {false, true}) {
    TravelExcess excess = excess_of(travel, above ? range.high : range.low, above);
    if (excess.by_mm > result.by_mm) {
      excess.axis = static_cast<std::int8_t>(axis);
      result = excess;
    }
  }
  return result;
}

std::optional<TravelExcess> beyond_tolerance(const TravelExcess& worst) {
  return worst.by_mm > kTravelToleranceMm ? std::optional(worst) : std::nullopt;
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
  for (std::size_t axis = 0; axis < envelope.size(); ++axis) {
    worst = worse(worst, axis, envelope[axis], {.low = box.min_mm[axis], .high = box.max_mm[axis]});
  }
  return beyond_tolerance(worst);
}

std::optional<TravelExcess> outside_travel(const Envelope& envelope,
                                           const curves::Position& point) noexcept {
  return outside_travel(envelope, curves::Extents{.min_mm = point, .max_mm = point});
}

std::optional<TravelExcess> outside_travel(
    const AuxiliaryEnvelope& envelope, const curves::AuxiliaryPosition& position_rad_mm) noexcept {
  TravelExcess worst{.by_mm = kTravelToleranceMm};
  for (std::size_t k = 0; k < envelope.size(); ++k) {
    worst =
        worse(worst, 3 + k, {.min_mm = envelope[k].min_rad_mm, .max_mm = envelope[k].max_rad_mm},
              {.low = position_rad_mm[k], .high = position_rad_mm[k]});
  }
  return beyond_tolerance(worst);
}

std::string describe(const TravelExcess& excess) {
  const std::string name(1, "xyzabcuvw"[excess.axis]);
  if (!std::isfinite(excess.by_mm)) {
    return name + " is not a finite number";
  }
  const bool turns = excess.axis >= 3 && excess.axis < 6;
  const double factor = turns ? kDegreesPerRadian : 1.0;
  const std::string unit = turns ? " deg" : " mm";
  return name + " goes " + text_of(factor * excess.by_mm) + unit + " beyond its " +
         (excess.above ? "upper" : "lower") + " limit of " + text_of(factor * excess.limit_mm) +
         unit;
}

}  // namespace kerf::machine
