// How often something took how long.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf::program {

// Of times from 1 ns to a quarter of an hour, told apart by a sixteenth. add() is for the tick: it
// allocates nothing, and costs the same always.
class TimeHistogram {
 public:
  struct Step {
    double up_to_s = 0.0;
    std::uint64_t count = 0;  // longer than the step before
  };

  // A time below 0 counts as 0.
  void add(std::int64_t time_ns) noexcept;
  void add(const TimeHistogram& other) noexcept;

  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
  [[nodiscard]] double worst_s() const noexcept;
  [[nodiscard]] double mean_s() const noexcept;
  // That share of the times is not longer, to a sixteenth and never too short; share in 0..1.
  [[nodiscard]] double quantile_s(double share) const noexcept;
  // In steps of 1, 2 and 5 from 1 us on, as far as there are times; one that is within a sixteenth
  // of a step's end may count in the next.
  [[nodiscard]] std::vector<Step> steps() const;

 private:
  static constexpr std::size_t kCells = 592;

  [[nodiscard]] static std::size_t cell_of(std::uint64_t time_ns) noexcept;
  [[nodiscard]] static std::int64_t end_ns(std::size_t cell) noexcept;  // the longest time in it

  std::array<std::uint64_t, kCells> cells_{};
  std::uint64_t count_ = 0;
  std::int64_t worst_ns_ = 0;
  double sum_ns_ = 0.0;
};

}  // namespace kerf::program
