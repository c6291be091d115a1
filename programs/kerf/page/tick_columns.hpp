// What each tick has of feedrate, acceleration, jerk, following error and deviation, in bounded
// memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "programs/kerf/report/extra_axes.hpp"
#include "programs/kerf/report/tick_record.hpp"

namespace kerf::program {

// Smallest and largest value of each column, in the order of time. Where a column is a tick, max is
// empty.
struct ColumnSeries {
  std::vector<float> min;
  std::vector<float> max;
};

// Those ticks of a run that have columns, both ends among them.
struct TickWindow {
  std::int64_t first = 0;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};

// Ticks fall into columns of 2^k ticks. While k = 0 a column is a tick; when the columns run out,
// neighbours merge and k grows by one. So every peak is kept, at its column.
//
// The series are v, a and j along the path as planned (v_mm_s, a_mm_s2, j_mm_s3), then of X, Y, Z
// and the machine's other axes by finite differences of positions, as the judge of a run takes
// them, then the distance between commanded and actual position in mm, and last how far the path
// there may be from the programmed one.
class TickColumns {
 public:
  static constexpr std::size_t kMaxColumns = 200'000;

  struct Settings {
    double period_s = 0.001;
    std::vector<ExtraAxis> extra{};         // that the machine has
    std::size_t max_columns = kMaxColumns;  // even, at least 2
    TickWindow window{};
  };
  explicit TickColumns(const Settings& settings);

  // Ticks come one by one from 0 on.
  void add(const TickRecord& record);

  // No tick that comes has a column any more.
  [[nodiscard]] bool has_all() const noexcept { return ticks_ > window_.last; }
  [[nodiscard]] std::int64_t first_tick() const noexcept { return window_.first; }
  [[nodiscard]] std::int64_t ticks_per_column() const noexcept { return ticks_per_column_; }
  [[nodiscard]] std::size_t columns() const noexcept { return limits_.size(); }
  // 3 + 3 * axes + 2 of them.
  [[nodiscard]] const std::vector<ColumnSeries>& series() const noexcept { return series_; }
  // The active constraint of each column. In one of several ticks it is the one that lasts longest
  // in either half of it.
  [[nodiscard]] std::vector<std::uint8_t> limits() const;

 private:
  struct LimitShare {
    std::uint8_t limit = 0;
    std::uint32_t ticks = 0;
  };

  // Of one axis: its last three positions, newest first, and its series of v, a, j.
  struct Track {
    std::array<double, 3> x{};
    std::size_t first_series = 0;
  };

  // number: from the first that has a column.
  void take_tick(const TickRecord& record, std::int64_t number);
  void take(ColumnSeries& into, double value) const;
  // In the order of the tracks.
  [[nodiscard]] double place(const TickRecord& record, std::size_t track) const;
  void take_axis(const Track& track, double x);
  void take_limit(std::uint8_t limit);
  void halve();

  std::vector<Track> tracks_;
  std::vector<ExtraAxis> extra_;
  std::size_t max_columns_;
  TickWindow window_;
  std::int64_t ticks_per_column_ = 1;
  std::int64_t ticks_ = 0;  // that have come
  bool opens_column_ = false;
  double period_s_;
  std::vector<ColumnSeries> series_;
  std::vector<LimitShare> limits_;
  std::array<std::uint32_t, interp::kConstraints> counts_{};  // of the last column
};

}  // namespace kerf::program
