// Sigmoid with cubic ends.
#pragma once

#include "profiles/feedrate_shape.hpp"
#include "profiles/reach.hpp"

namespace kerf::profiles {

// The middle third of phi is a logistic curve of shape s, the outer thirds are the cubics that join
// it with continuous acceleration and start from acceleration 0 (docs/math.md, 2.6). Jerk jumps at
// the ends and at the joints.
class Sigmoid {
 public:
  // Above the largest s the cubic would dip below 0: its b2 = 27 phi(1/3) - 3 phi'(1/3) changes
  // sign at 5.1119. The smallest is all but the limit s -> 0, a linear middle.
  static constexpr double kSmallestShape = 0.1;
  static constexpr double kLargestShape = 5.11;
  // The range in which s is worth choosing. At the upper end j* is lowest (the cubic's jerk at
  // x = 0 falls with s, the logistic's at x = 1/3 grows); at the lower a* is (the cubic's peak
  // falls with s, the logistic's grows). Outside both peaks grow.
  static constexpr double kJerkBestShape = 3.3112349617243853;
  static constexpr double kAccelerationBestShape = 1.6970718790675121;

  Sigmoid() noexcept : Sigmoid(kJerkBestShape) {}
  // shape in [kSmallestShape, kLargestShape]; clamped.
  explicit Sigmoid(double shape) noexcept;

  // The s of the shortest duration: kJerkBestShape where jerk binds throughout,
  // kAccelerationBestShape where acceleration does, else where both bind at once.
  static Sigmoid fastest(double change_mm_s, const RampLimits& limits);
  // The duration of that, and the change that reaches over a length (see profiles/reach.hpp).
  static double duration_s(double change_mm_s, const RampLimits& limits);
  static double reachable_change(const Approach& approach, const RampLimits& limits);

  [[nodiscard]] double shape() const noexcept { return shape_; }
  [[nodiscard]] ShapeValue at(double x) const noexcept;
  [[nodiscard]] double peak_acceleration() const noexcept { return peaks().acceleration; }
  [[nodiscard]] double peak_jerk() const noexcept { return peaks().jerk; }
  // The true peaks of the shape; the paper's bound of j* is a little higher where the logistic's
  // own extreme lies outside the middle third.
  [[nodiscard]] ShapePeaks peaks() const noexcept;

 private:
  struct Cubic {  // phi = b1 x^3 + b2 x^2
    double b1;
    double b2;
  };
  [[nodiscard]] Cubic cubic() const noexcept;

  double shape_;
  double gain_;        // 1 / (2 tanh(s / 2)): phi = 1/2 + gain tanh(s (x - 1/2)) in the middle
  double joint_tanh_;  // tanh(s / 6), at the joint x = 2/3
};

static_assert(FeedrateShape<Sigmoid>);

}  // namespace kerf::profiles
