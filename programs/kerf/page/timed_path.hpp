// Where the tool is at each time, in bounded memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "curves/position.hpp"

namespace kerf::program {

struct TimedPoint {
  std::int64_t tick = 0;
  curves::Position position_mm{};
  bool rapid = false;  // the way to here is a rapid
};

// Points go in tick by tick; one is kept where the straight line over time from the last kept point
// would be more than the tolerance off in X, Y or Z, or where a rapid begins or ends. So place and
// feedrate between kept points follow from them. When they run out the tolerance doubles and the
// path is thinned by the same rule. Where half of the points were begins and ends of rapids, those
// are no longer kept, and a stretch is what it ends as.
//
// The rule is a sleeve: the slopes over time that pass every point since the last kept one within
// the tolerance form an interval for each axis, which only narrows. A point is constant work.
class TimedPath {
 public:
  static constexpr std::size_t kMaxPoints = 150'000;

  struct Settings {
    double tolerance_mm = 1e-6;           // > 0
    std::size_t max_points = kMaxPoints;  // >= 16
  };
  explicit TimedPath(const Settings& settings);

  void add(const TimedPoint& point);

  // The kept points and the last one.
  [[nodiscard]] std::vector<TimedPoint> points() const;
  // Of the kept points: how far the path may be from them at any tick, for each axis.
  [[nodiscard]] double tolerance_mm() const noexcept { return error_mm_; }
  // False: there were too many begins and ends of rapids.
  [[nodiscard]] bool tells_rapids() const noexcept { return tells_rapids_; }

 private:
  struct Slope {
    double low = 0.0;
    double high = 0.0;
  };

  // False: the stretch ends before the point.
  bool extends(const TimedPoint& point);
  void append(const TimedPoint& point);
  void keep(const TimedPoint& point);
  void thin();
  [[nodiscard]] bool is_full_of_rapids() const;

  double tolerance_mm_;
  double error_mm_;
  std::size_t max_points_;
  std::vector<TimedPoint> kept_;
  std::optional<TimedPoint> last_;  // the newest point, unless it is kept
  std::array<Slope, 3> slopes_{};
  bool narrowed_ = false;
  bool tells_rapids_ = true;
};

}  // namespace kerf::program
