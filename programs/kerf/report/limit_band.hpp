// The active constraint over time, in bounded memory, for the plot.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "programs/kerf/report/constraint_text.hpp"

namespace kerf::program {

// Ticks fall into buckets of 2^k ticks, each of which counts its limits; when the buckets run out,
// neighbours merge and k grows by one.
class LimitBand {
 public:
  static constexpr std::size_t kBuckets = 1024;

  LimitBand();

  // Ticks come in ascending order; gaps are allowed. Allocates nothing.
  void add(std::int64_t tick, Constraint limit) noexcept;

  // From its first tick up to that of the next interval, the limit that most of the ticks have.
  struct Interval {
    std::int64_t tick = 0;
    Constraint limit{};
  };
  [[nodiscard]] std::vector<Interval> intervals() const;

 private:
  using Counts = std::array<std::uint32_t, interp::kConstraints>;

  void halve() noexcept;

  std::int64_t ticks_per_bucket_ = 1;
  std::vector<Counts> buckets_;
  std::size_t used_ = 0;
};

}  // namespace kerf::program
