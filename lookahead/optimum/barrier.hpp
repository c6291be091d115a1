// The wall in front of a limit, which the solver feels but may break through.
#pragma once

#include <cmath>

namespace kerf::lookahead {

// Of a slack z (the share of a limit that is left): -ln z, and below `relaxed` the parabola that
// goes on from there with the same slope and bend (Hauser and Saccon, "A barrier function method
// for the optimization of trajectory functionals with constraints", CDC 2006). It is finite
// everywhere, so the search may begin anywhere; where an optimum keeps more slack than `relaxed`,
// it is that of the logarithm.
class Barrier {
 public:
  explicit Barrier(double relaxed) noexcept : relaxed_(relaxed) {}

  struct Slopes {
    double fall = 0.0;  // minus the first derivative, > 0
    double bend = 0.0;  // the second
  };

  // Sums up over many slacks: one logarithm of their product.
  struct Sum {
    double product = 1.0;
    double rest = 0.0;

    [[nodiscard]] double value() const { return rest - std::log(product); }
  };

  void add(double slack, Sum& sum) const noexcept {
    if (slack >= relaxed_) {
      sum.product *= slack;
    } else {
      const double x = (slack - 2.0 * relaxed_) / relaxed_;
      sum.rest += 0.5 * (x * x - 1.0) - std::log(relaxed_);
    }
  }

  [[nodiscard]] Slopes slopes(double slack) const noexcept {
    if (slack >= relaxed_) {
      const double inverse = 1.0 / slack;
      return {.fall = inverse, .bend = inverse * inverse};
    }
    return {.fall = (2.0 * relaxed_ - slack) / (relaxed_ * relaxed_),
            .bend = 1.0 / (relaxed_ * relaxed_)};
  }

 private:
  double relaxed_;
};

}  // namespace kerf::lookahead
