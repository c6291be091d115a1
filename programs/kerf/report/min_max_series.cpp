#include "programs/kerf/report/min_max_series.hpp"

namespace kerf::program {

MinMaxSeries::MinMaxSeries(std::size_t max_buckets) : max_buckets_(max_buckets) {
  buckets_.reserve(max_buckets);
}

void MinMaxSeries::merge(Bucket& into, const Bucket& from) noexcept {
  if (from.min.value < into.min.value) {
    into.min = from.min;
  }
  if (from.max.value > into.max.value) {
    into.max = from.max;
  }
}

void MinMaxSeries::halve() noexcept {
  ticks_per_bucket_ *= 2;
  std::size_t kept = 0;
  for (Bucket bucket : buckets_) {
    bucket.number /= 2;
    if (kept > 0 && buckets_[kept - 1].number == bucket.number) {
      merge(buckets_[kept - 1], bucket);
    } else {
      buckets_[kept++] = bucket;
    }
  }
  buckets_.resize(kept);
}

void MinMaxSeries::add(std::int64_t tick, double value) noexcept {
  const SeriesPoint point{.tick = tick, .value = value};
  if (!buckets_.empty() && buckets_.back().number == tick / ticks_per_bucket_) {
    const std::int64_t number = buckets_.back().number;
    merge(buckets_.back(), {.number = number, .min = point, .max = point});
    return;
  }
  // Buckets between which there are gaps do not merge at once.
  while (buckets_.size() == max_buckets_) {
    halve();
  }
  const std::int64_t number = tick / ticks_per_bucket_;
  const Bucket bucket{.number = number, .min = point, .max = point};
  if (!buckets_.empty() && buckets_.back().number == number) {
    merge(buckets_.back(), bucket);
  } else {
    buckets_.push_back(bucket);
  }
}

std::vector<SeriesPoint> MinMaxSeries::points() const {
  std::vector<SeriesPoint> points;
  points.reserve(2 * buckets_.size());
  for (const Bucket& bucket : buckets_) {
    const bool min_first = bucket.min.tick <= bucket.max.tick;
    points.push_back(min_first ? bucket.min : bucket.max);
    if (bucket.min.tick != bucket.max.tick) {
      points.push_back(min_first ? bucket.max : bucket.min);
    }
  }
  return points;
}

std::vector<SeriesBand> MinMaxSeries::bands() const {
  std::vector<SeriesBand> bands;
  bands.reserve(buckets_.size());
  for (const Bucket& bucket : buckets_) {
    bands.push_back({.tick = bucket.number * ticks_per_bucket_,
                     .min = bucket.min.value,
                     .max = bucket.max.value});
  }
  return bands;
}

}  // namespace kerf::program
