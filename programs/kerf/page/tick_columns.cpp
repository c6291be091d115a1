#include "programs/kerf/page/tick_columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kerf::program {

namespace {

constexpr std::size_t kAxes = 3;
constexpr std::size_t kPerTrack = 3;  // v, a, j

}  // namespace

TickColumns::TickColumns(const Settings& settings)
    : tracks_(kAxes + settings.extra.size()),
      extra_(settings.extra),
      max_columns_(settings.max_columns),
      window_(settings.window),
      period_s_(settings.period_s),
      series_(kPerTrack * (1 + tracks_.size()) + 2) {
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    tracks_[k].first_series = kPerTrack * (1 + k);
  }
}

void TickColumns::take(ColumnSeries& into, double value) const {
  const auto figure = static_cast<float>(value);
  if (ticks_per_column_ == 1) {
    into.min.push_back(figure);
  } else if (opens_column_) {
    into.min.push_back(figure);
    into.max.push_back(figure);
  } else {
    into.min.back() = std::min(into.min.back(), figure);
    into.max.back() = std::max(into.max.back(), figure);
  }
}

double TickColumns::place(const TickRecord& record, std::size_t track) const {
  if (track < kAxes) {
    return record.position_mm[track];
  }
  const ExtraAxis& axis = extra_[track - kAxes];
  return axis.factor * record.extra_rad_mm[axis.index];
}

void TickColumns::take_axis(const Track& track, double x) {
  const auto [x1, x2, x3] = track.x;
  const std::size_t first = track.first_series;
  take(series_[first], (x - x1) / period_s_);
  take(series_[first + 1], (x - 2.0 * x1 + x2) / (period_s_ * period_s_));
  take(series_[first + 2], (x - 3.0 * (x1 - x2) - x3) / (period_s_ * period_s_ * period_s_));
}

void TickColumns::take_limit(std::uint8_t limit) {
  if (opens_column_) {
    counts_ = {};
    limits_.push_back({.limit = limit, .ticks = 0});
  }
  const std::uint32_t ticks = ++counts_[limit];
  if (ticks > limits_.back().ticks) {
    limits_.back() = {.limit = limit, .ticks = ticks};
  }
}

void TickColumns::add(const TickRecord& record) {
  const std::int64_t tick = ticks_++;
  for (std::size_t k = 0; k < tracks_.size() && tick == 0; ++k) {
    tracks_[k].x.fill(place(record, k));
  }
  if (tick >= window_.first && tick <= window_.last) {
    take_tick(record, tick - window_.first);
  }
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    auto& x = tracks_[k].x;
    x = {place(record, k), x[0], x[1]};
  }
}

void TickColumns::take_tick(const TickRecord& record, std::int64_t number) {
  opens_column_ = number % ticks_per_column_ == 0;
  if (opens_column_ && limits_.size() == max_columns_) {
    halve();
    opens_column_ = number % ticks_per_column_ == 0;
  }
  take(series_[0], record.motion.v_mm_s);
  take(series_[1], record.motion.a_mm_s2);
  take(series_[2], record.motion.j_mm_s3);
  for (std::size_t k = 0; k < tracks_.size(); ++k) {
    take_axis(tracks_[k], place(record, k));
  }
  take(series_[series_.size() - 2], std::hypot(record.actual_mm[0] - record.position_mm[0],
                                               record.actual_mm[1] - record.position_mm[1],
                                               record.actual_mm[2] - record.position_mm[2]));
  take(series_.back(), record.detail.deviation_mm);
  take_limit(static_cast<std::uint8_t>(record.limit));
}

void TickColumns::halve() {
  for (ColumnSeries& series : series_) {
    if (ticks_per_column_ == 1) {
      series.max = series.min;
    }
    const std::size_t half = series.min.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
      series.min[i] = std::min(series.min[2 * i], series.min[2 * i + 1]);
      series.max[i] = std::max(series.max[2 * i], series.max[2 * i + 1]);
    }
    series.min.resize(half);
    series.max.resize(half);
  }
  ticks_per_column_ *= 2;
  const std::size_t half = limits_.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const LimitShare& a = limits_[2 * i];
    const LimitShare& b = limits_[2 * i + 1];
    limits_[i] = a.limit == b.limit  ? LimitShare{.limit = a.limit, .ticks = a.ticks + b.ticks}
                 : b.ticks > a.ticks ? b
                                     : a;
  }
  limits_.resize(half);
}

std::vector<std::uint8_t> TickColumns::limits() const {
  std::vector<std::uint8_t> limits(limits_.size());
  std::transform(limits_.begin(), limits_.end(), limits.begin(),
                 [](const LimitShare& share) { return share.limit; });
  return limits;
}

}  // namespace kerf::program
