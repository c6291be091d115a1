#include "programs/kerf/report/time_histogram.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace kerf::program {

namespace {

constexpr double kSecond_ns = 1e9;
constexpr std::uint64_t kSixteen = 16;

double seconds(std::int64_t time_ns) noexcept {
  return static_cast<double>(time_ns) / kSecond_ns;
}

}  // namespace

// Below 32 ns a cell a nanosecond, from there on 16 cells an octave.
std::size_t TimeHistogram::cell_of(std::uint64_t time_ns) noexcept {
  const int shift = std::max(0, static_cast<int>(std::bit_width(time_ns)) - 5);
  const std::uint64_t cell =
      kSixteen * static_cast<std::uint64_t>(shift) + (time_ns >> static_cast<unsigned>(shift));
  return std::min<std::uint64_t>(cell, kCells - 1);
}

std::int64_t TimeHistogram::end_ns(std::size_t cell) noexcept {
  if (cell < 2 * kSixteen) {
    return static_cast<std::int64_t>(cell);
  }
  const std::uint64_t shift = cell / kSixteen - 1;
  return static_cast<std::int64_t>(((cell - kSixteen * shift + 1) << shift) - 1);
}

void TimeHistogram::add(std::int64_t time_ns) noexcept {
  const std::int64_t time = std::max<std::int64_t>(time_ns, 0);
  ++cells_[cell_of(static_cast<std::uint64_t>(time))];
  ++count_;
  worst_ns_ = std::max(worst_ns_, time);
  sum_ns_ += static_cast<double>(time);
}

void TimeHistogram::add(const TimeHistogram& other) noexcept {
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    cells_[cell] += other.cells_[cell];
  }
  count_ += other.count_;
  worst_ns_ = std::max(worst_ns_, other.worst_ns_);
  sum_ns_ += other.sum_ns_;
}

double TimeHistogram::worst_s() const noexcept {
  return seconds(worst_ns_);
}

double TimeHistogram::mean_s() const noexcept {
  return count_ > 0 ? sum_ns_ / static_cast<double>(count_) / kSecond_ns : 0.0;
}

double TimeHistogram::quantile_s(double share) const noexcept {
  const double wanted = std::ceil(share * static_cast<double>(count_));
  std::uint64_t found = 0;
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    found += cells_[cell];
    if (found > 0 && static_cast<double>(found) >= wanted) {
      return cell + 1 < kCells ? seconds(std::min(end_ns(cell), worst_ns_)) : worst_s();
    }
  }
  return worst_s();
}

std::vector<TimeHistogram::Step> TimeHistogram::steps() const {
  std::vector<Step> steps;
  std::size_t cell = 0;
  std::uint64_t left = count_;
  for (std::int64_t decade_ns = 1000; left > 0; decade_ns *= 10) {
    for (const std::int64_t factor : {1, 2, 5}) {
      Step step{.up_to_s = seconds(factor * decade_ns)};
      for (; cell < kCells && end_ns(cell) <= factor * decade_ns; ++cell) {
        step.count += cells_[cell];
      }
      left -= step.count;
      if (step.count > 0 || !steps.empty()) {
        steps.push_back(step);
      }
      if (left == 0) {
        break;
      }
    }
  }
  return steps;
}

}  // namespace kerf::program
