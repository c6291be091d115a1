// One side of the hill of allowed feedrate between two valleys, seen from its foot.
#pragma once

#include <limits>
#include <vector>

#include "lookahead/ceiling.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

// The feedrate allowed at a distance from the foot, made monotone: at each point the lowest that
// the ceiling comes down to between there and the top. Empty: no ceiling, any feedrate is allowed.
class Slope {
 public:
  struct Sample {
    double distance_mm = 0.0;
    double v_mm_s = 0.0;
  };

  Slope() = default;
  // Samples from the foot to the top, distance ascending from 0.
  explicit Slope(std::vector<Sample> samples);

  [[nodiscard]] bool empty() const noexcept { return samples_.empty(); }
  // The highest feedrate allowed anywhere: at the top.
  [[nodiscard]] double top_mm_s() const noexcept;

  // How long a transition from the foot upwards must be made to stay below the ceiling, as a factor
  // >= 1 on the length and duration of climb. A stretched transition passes through the same
  // feedrates at the same shares of its length, so each of its points asks for a length of its own
  // and the largest decides: no iteration. Judged at kClimbPoints points of the transition.
  [[nodiscard]] double stretch_for(const profiles::Transition& climb) const;
  // How far from the foot the climb must begin instead, unstretched: for a law whose acceleration
  // jumps, which no stretch keeps below a ceiling that is flat at the foot. Judged at kStartPoints.
  [[nodiscard]] double delay_for_mm(const profiles::Transition& climb) const;

 private:
  static constexpr int kClimbPoints = 64;
  static constexpr int kStartPoints = 512;  // where a jump of acceleration meets the ceiling
  static constexpr double kHighest = std::numeric_limits<double>::infinity();
  // Calls visit(motion of the climb, distance from which its feedrate is allowed) point by point.
  template <typename Visit>
  void walk(const profiles::Transition& climb, int points, const Visit& visit) const;

  std::vector<Sample> samples_;
};

}  // namespace kerf::lookahead
