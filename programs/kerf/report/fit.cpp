#include "programs/kerf/report/fit.hpp"

#include <algorithm>
#include <cmath>

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include "machine/envelope.hpp"
#include "programs/kerf/io/number_text.hpp"

namespace kerf::program {

namespace {

double over_mm(const AxisRange& range, const Travel& travel) {
  const double over_mm =
      range.is_empty() ? 0.0 : std::max(travel.min_mm - range.min_mm, range.max_mm - travel.max_mm);
  return over_mm > machine::kTravelToleranceMm ? over_mm : 0.0;
}

OffsetRange range_of(const AxisRange& path, const Travel& travel, double origin_mm) {
  return {.min_mm = origin_mm + travel.min_mm - path.min_mm,
          .max_mm = origin_mm + travel.max_mm - path.max_mm};
}

// Axis by axis, in words.
std::optional<std::string> excess_of(const AuxiliaryExtents& filled,
                                     const machine::AuxiliaryEnvelope& envelope) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < envelope.size(); ++k) {
    machine::AuxiliaryEnvelope of_axis{};
    of_axis[k] = envelope[k];
    for (const auto& place_rad_mm : {filled.min_rad_mm, filled.max_rad_mm}) {
      if (const auto excess = machine::outside_travel(of_axis, place_rad_mm)) {
        words.push_back(machine::describe(*excess));
      }
    }
  }
  return words.empty() ? std::nullopt : std::optional(fmt::format("{}", fmt::join(words, "; ")));
}

std::string range_text(const OffsetRange& range) {
  // Inwards: an offset that is written here fits.
  const double low = std::ceil(range.min_mm * 1e3) / 1e3;
  const double high = std::floor(range.max_mm * 1e3) / 1e3;
  if (high < low) {  // between two thousandths
    constexpr int kNanometres = 6;
    return fmt::format("at {}", fixed_number(0.5 * (range.min_mm + range.max_mm), kNanometres));
  }
  if (!std::isfinite(low)) {
    return fmt::format("at most {}", fixed_number(high, 3));
  }
  if (!std::isfinite(high)) {
    return fmt::format("at least {}", fixed_number(low, 3));
  }
  return fmt::format("between {} and {}", fixed_number(low, 3), fixed_number(high, 3));
}

}  // namespace

bool FitReport::fits() const noexcept {
  return !extra_excess && std::all_of(axes.begin(), axes.end(),
                                      [](const AxisFit& axis) { return axis.over_mm <= 0.0; });
}

std::string work_system_name(std::size_t system) {
  if (system < 6) {
    return fmt::format("G{}", 54 + system);
  }
  return system < kWorkSystems ? fmt::format("G59.{}", system - 5)
                               : fmt::format("G54.1 P{}", system - kWorkSystems + 1);
}

std::optional<FitReport> fit_of(const CheckReport& check, const MachineSettings& settings) {
  if (!check.moves) {
    return std::nullopt;
  }
  const OffsetExtents& offsets = check.offset_extents;
  FitReport fit;
  for (std::size_t k = 0; k < 3; ++k) {
    const Travel& travel = settings.table.axes[k].travel;
    fit.axes[k] = {.travel = travel,
                   .over_mm = over_mm({check.extents.min_mm[k], check.extents.max_mm[k]}, travel),
                   .fixed_over_mm = over_mm(offsets.fixed[k], travel)};
  }
  fit.extra_excess = excess_of(check.extra_extents, settings.table.extra);
  for (std::size_t system = 0; system < kWorkSystems; ++system) {
    OffsetFit one{.name = work_system_name(system),
                  .origin_mm = settings.program.work[system].origin_mm};
    for (std::size_t k = 0; k < 3; ++k) {
      const AxisRange& path = offsets.following[system][k];
      if (offsets.is_known[k] && !path.is_empty()) {
        one.ranges[k] = range_of(path, fit.axes[k].travel, one.origin_mm[k]);
      }
    }
    if (std::any_of(one.ranges.begin(), one.ranges.end(),
                    [](const auto& range) { return range.has_value(); })) {
      fit.offsets.push_back(std::move(one));
    }
  }
  return fit;
}

std::vector<std::string> describe(const FitReport& fit) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisFit& axis = fit.axes[k];
    const char name = "XYZ"[k];
    if (axis.over_mm <= 0.0) {
      continue;
    }
    if (axis.fixed_over_mm > 0.0) {
      lines.push_back(fmt::format("no work offset: {} leaves the travel by {} mm wherever it lies",
                                  name, fixed_number(axis.fixed_over_mm, 3)));
      continue;
    }
    for (const OffsetFit& offset : fit.offsets) {
      const auto& range = offset.ranges[k];
      if (!range ||
          (range->min_mm <= offset.origin_mm[k] && offset.origin_mm[k] <= range->max_mm)) {
        continue;
      }
      lines.push_back(range->is_empty()
                          ? fmt::format("no {} {}: the path is {} mm longer than the travel",
                                        offset.name, name,
                                        fixed_number(range->min_mm - range->max_mm, 3))
                          : fmt::format("{} {} {}", offset.name, name, range_text(*range)));
    }
  }
  return lines;
}

}  // namespace kerf::program
