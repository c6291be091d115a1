#include "programs/kerf/page/timed_path.hpp"

#include <algorithm>
#include <utility>

namespace kerf::program {

TimedPath::TimedPath(const Settings& settings)
    : tolerance_mm_(settings.tolerance_mm),
      error_mm_(settings.tolerance_mm),
      max_points_(settings.max_points) {}

bool TimedPath::extends(const TimedPoint& point) {
  const TimedPoint& from = kept_.back();
  if (tells_rapids_ && last_ && point.rapid != last_->rapid) {
    return false;
  }
  const auto ticks = static_cast<double>(point.tick - from.tick);
  std::array<Slope, 3> slopes{};
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    const double way_mm = point.position_mm[k] - from.position_mm[k];
    const double slope = way_mm / ticks;
    slopes[k] = {.low = (way_mm - tolerance_mm_) / ticks, .high = (way_mm + tolerance_mm_) / ticks};
    if (narrowed_) {
      // The line to this point is to pass all those before it.
      if (slope < slopes_[k].low || slope > slopes_[k].high) {
        return false;
      }
      slopes[k] = {.low = std::max(slopes[k].low, slopes_[k].low),
                   .high = std::min(slopes[k].high, slopes_[k].high)};
    }
  }
  slopes_ = slopes;
  narrowed_ = true;
  return true;
}

void TimedPath::keep(const TimedPoint& point) {
  kept_.push_back(point);
  last_.reset();
  narrowed_ = false;
}

void TimedPath::append(const TimedPoint& point) {
  if (kept_.empty()) {
    keep(point);
    return;
  }
  if (!extends(point)) {
    keep(*last_);
    extends(point);
  }
  last_ = point;
}

void TimedPath::add(const TimedPoint& point) {
  append(point);
  // Thinning twice as wide need not be enough at once.
  while (kept_.size() >= max_points_) {
    thin();
  }
}

// A wider sleeve drops no place where a rapid begins or ends: there may be too many of them.
bool TimedPath::is_full_of_rapids() const {
  std::size_t changes = 0;
  for (std::size_t i = 1; i < kept_.size(); ++i) {
    changes += kept_[i].rapid != kept_[i - 1].rapid ? 1U : 0U;
  }
  return 2 * changes >= kept_.size();
}

void TimedPath::thin() {
  tolerance_mm_ *= 2.0;
  tells_rapids_ = tells_rapids_ && !is_full_of_rapids();
  TimedPath thinner({.tolerance_mm = tolerance_mm_, .max_points = kept_.size() + 2});
  thinner.tells_rapids_ = tells_rapids_;
  for (const TimedPoint& point : kept_) {
    thinner.append(point);
  }
  // Closed at its end, as this path is here.
  if (thinner.last_) {
    thinner.keep(*thinner.last_);
  }
  kept_ = std::move(thinner.kept_);
  // What was off the kept points before adds to what they are off now.
  error_mm_ += tolerance_mm_;
  narrowed_ = false;
  if (last_) {
    append(*std::exchange(last_, std::nullopt));
  }
}

std::vector<TimedPoint> TimedPath::points() const {
  std::vector<TimedPoint> points = kept_;
  if (last_) {
    points.push_back(*last_);
  }
  return points;
}

}  // namespace kerf::program
