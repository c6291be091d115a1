// One side of the velocity limit curve between two valleys, from its lower end (the foot) to the
// highest place (the top).
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "lookahead/path/path_sample.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

// The feedrate allowed at a distance from the foot, made monotone: at each point the lowest value
// of the limit curve between there and the top. Empty: no limit curve, any feedrate is allowed.
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

  // The lowest feedrate allowed anywhere: at the foot.
  [[nodiscard]] double bottom_mm_s() const noexcept;
  // The same side seen from a foot that far up.
  [[nodiscard]] Slope from(double distance_mm) const;

  // The distance from which a feedrate is allowed; that of the top for a feedrate above it.
  // Precondition: not empty.
  [[nodiscard]] double allowed_from_mm(double v_mm_s) const;

  // The factor >= 1 on length and duration by which a transition from the foot upwards must be
  // stretched to stay below the limit curve. A stretched transition passes through the same
  // feedrates at the same shares of its length, so each of its points needs a length of its own and
  // the largest decides: no iteration. The ramp is then nowhere more than 5e-5 of its feedrate
  // above the limit curve.
  [[nodiscard]] double stretch_for(const profiles::Transition& ramp) const;
  // The distance from the foot at which the ramp must begin instead, unstretched: for a law whose
  // acceleration jumps, which no stretch keeps below a limit curve that is flat at the foot.
  [[nodiscard]] double delay_for_mm(const profiles::Transition& ramp) const;

 private:
  template <typename Ask>
  class Search;
  // Where a feedrate is allowed from, on the straight line that ends with the sample of that
  // number.
  struct Allowed {
    double from_mm = 0.0;
    std::size_t line = 0;  // 0: from the foot on
  };
  [[nodiscard]] Allowed allowed(double v_mm_s) const;
  // Of a line that rises: how much later a higher feedrate is allowed.
  [[nodiscard]] double mm_per_mm_s(std::size_t line) const;
  static constexpr double kHighest = std::numeric_limits<double>::infinity();
  std::vector<Sample> samples_;
};

}  // namespace kerf::lookahead
