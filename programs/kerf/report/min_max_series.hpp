// A curve over time of any length in bounded memory, with every peak kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf::program {

struct SeriesPoint {
  std::int64_t tick = 0;
  double value = 0.0;
};

// The smallest and the largest value of some ticks from this one on.
struct SeriesBand {
  std::int64_t tick = 0;
  double min = 0.0;
  double max = 0.0;
};

// Ticks fall into buckets of 2^k ticks, of which only the smallest and the largest value are kept,
// each at its own tick. When the buckets run out, neighbours merge and k grows by one. As long as k
// = 0 the curve is exact.
class MinMaxSeries {
 public:
  // Preconditions: max_buckets is even and at least 2.
  explicit MinMaxSeries(std::size_t max_buckets = 2000);

  // Ticks come in ascending order; gaps are allowed. Allocates nothing.
  void add(std::int64_t tick, double value) noexcept;

  // In the order of time, at most two points a bucket.
  [[nodiscard]] std::vector<SeriesPoint> points() const;
  // The same, bucket by bucket.
  [[nodiscard]] std::vector<SeriesBand> bands() const;
  [[nodiscard]] std::int64_t ticks_per_band() const noexcept { return ticks_per_bucket_; }

 private:
  struct Bucket {
    std::int64_t number = 0;
    SeriesPoint min{};
    SeriesPoint max{};
  };

  static void merge(Bucket& into, const Bucket& from) noexcept;
  void halve() noexcept;

  std::size_t max_buckets_;
  std::int64_t ticks_per_bucket_ = 1;
  std::vector<Bucket> buckets_;
};

}  // namespace kerf::program
