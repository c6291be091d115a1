#include "programs/kerf/report/limit_band.hpp"

#include <algorithm>

namespace kerf::program {

LimitBand::LimitBand() : buckets_(kBuckets) {}

void LimitBand::add(std::int64_t tick, Constraint limit) noexcept {
  while (tick / ticks_per_bucket_ >= static_cast<std::int64_t>(kBuckets)) {
    halve();
  }
  const auto at = static_cast<std::size_t>(tick / ticks_per_bucket_);
  ++buckets_[at][static_cast<std::size_t>(limit)];
  used_ = at + 1;
}

void LimitBand::halve() noexcept {
  for (std::size_t i = 0; i < kBuckets; ++i) {
    const Counts from = buckets_[i];
    buckets_[i] = {};
    Counts& into = buckets_[i / 2];
    for (std::size_t k = 0; k < from.size(); ++k) {
      into[k] += from[k];
    }
  }
  ticks_per_bucket_ *= 2;
}

std::vector<LimitBand::Interval> LimitBand::intervals() const {
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i < used_; ++i) {
    const auto* const most = std::max_element(buckets_[i].begin(), buckets_[i].end());
    if (*most == 0) {
      continue;
    }
    const auto limit = static_cast<Constraint>(most - buckets_[i].begin());
    if (intervals.empty() || intervals.back().limit != limit) {
      intervals.push_back(
          {.tick = static_cast<std::int64_t>(i) * ticks_per_bucket_, .limit = limit});
    }
  }
  return intervals;
}

}  // namespace kerf::program
