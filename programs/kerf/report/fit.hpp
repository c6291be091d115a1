// Whether a program's path fits into the travel of the axes, and with which work offsets X, Y and Z
// would.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <kerf/check.hpp>
#include <kerf/machine.hpp>

namespace kerf::program {

// Between them the origin of a work offset along one axis may lie.
struct OffsetRange {
  double min_mm = 0.0;
  double max_mm = 0.0;  // below min_mm: nowhere, since the path is longer than the travel

  [[nodiscard]] bool is_empty() const noexcept { return max_mm < min_mm; }
};

// One that moves at least one of the axes.
struct OffsetFit {
  std::string name;  // "G54"
  Position origin_mm{};
  // Nothing: it does not move this axis, or more than move.
  std::array<std::optional<OffsetRange>, 3> ranges{};
};

struct AxisFit {
  Travel travel{};
  double over_mm = 0.0;  // by which the path leaves the travel, 0: it fits
  // Of what follows no work offset: it leaves the travel wherever they lie.
  double fixed_over_mm = 0.0;
};

struct FitReport {
  std::array<AxisFit, 3> axes{};
  std::vector<OffsetFit> offsets;
  // Of A, B, C, U, V, W the one that leaves its travel farthest, as a sentence: "a goes 80 deg
  // beyond its upper limit of 720 deg".
  std::optional<std::string> extra_excess{};

  [[nodiscard]] bool fits() const noexcept;
};

// "G54" of 0 to "G59.3" of 8, then "G54.1 P1" of 9 and on.
[[nodiscard]] std::string work_system_name(std::size_t system);

// Nothing without motion.
[[nodiscard]] std::optional<FitReport> fit_of(const CheckReport& check,
                                              const MachineSettings& settings);

// "G54 X between 12 and 340", one for each of X, Y and Z that does not fit, or why no offset would
// do.
[[nodiscard]] std::vector<std::string> describe(const FitReport& fit);

}  // namespace kerf::program
