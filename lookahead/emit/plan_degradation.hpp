// Where a plan is slower than its profile promises.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace kerf::lookahead {

struct PlanDegradation {
  enum class Kind : unsigned char {
    slower,     // up to its next stop the motion keeps its limits, but could be faster
    classical,  // up to its next stop it follows the plan of the S-curve
    stop        // the motion comes to rest there though the path does not ask for it
  };

  std::uint32_t line = 0;
  double s_mm = 0.0;  // from the line's begin: of the stop, or where the slower motion begins
  Kind kind = Kind::slower;
};

// All are counted, the first ones kept: memory does not grow with a program's length.
struct PlanDegradations {
  std::uint64_t count = 0;
  std::array<PlanDegradation, 8> first{};

  void add(const PlanDegradation& degradation) noexcept {
    if (count < first.size()) {
      first[static_cast<std::size_t>(count)] = degradation;
    }
    ++count;
  }
  [[nodiscard]] std::size_t kept() const noexcept {
    return std::min(static_cast<std::size_t>(count), first.size());
  }
};

}  // namespace kerf::lookahead
