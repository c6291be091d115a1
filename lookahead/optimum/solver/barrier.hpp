// The relaxed barrier of a limit: finite beyond the limit, too.
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace kerf::lookahead {

// Two cells side by side, which a processor computes at once: as many as every 64-bit processor
// has, so that the results are the same on all of them.
using SimdPair = Eigen::Array2d;
inline constexpr std::size_t kSimdWidth = 2;

// What is asked for of a sum of barriers.
enum class Order { value, derivatives };

// How sharp the barriers are.
struct BarrierWeights {
  double weight_s = 0.0;     // of each
  double stiffness_s = 0.0;  // stands for the weight in the second derivatives
  double relaxed = 0.0;      // Barrier
};

// Of a slack z (the share of a limit that is left): -ln z, and below `relaxed` the parabola that
// goes on from there with the same slope and bend (Hauser and Saccon, "A barrier function method
// for the optimization of trajectory functionals with constraints", CDC 2006). It is finite
// everywhere, so the search may begin anywhere; where an optimum keeps more slack than `relaxed`,
// it is that of the logarithm.
//
// Without a branch: with m = max(z, relaxed) and x = (m - z) / m the barrier is x + x^2 / 2 - ln m,
// its fall (1 + x) / m and its bend 1 / m^2.
class Barrier {
 public:
  explicit Barrier(double relaxed) noexcept : relaxed_(relaxed) {}

  struct Slopes {
    SimdPair rise;  // the first derivative by the form
    SimdPair bend;  // the second
  };

  // The sum of many barriers: one logarithm of the product of their slacks. Take it after the
  // limits of one cell; a product of more might underflow.
  struct Sum {
    SimdPair product = SimdPair::Ones();
    SimdPair rest = SimdPair::Zero();

    [[nodiscard]] SimdPair value() const { return rest - product.log(); }
  };

  // form <= 1
  [[nodiscard]] Slopes below(const SimdPair& form, Sum& sum) const noexcept {
    const SimdPair z = 1.0 - form;
    const SimdPair m = z.max(relaxed_);
    const SimdPair inverse = 1.0 / m;
    const SimdPair x = (m - z) * inverse;
    sum.product *= m;
    sum.rest += x + 0.5 * x * x;
    return {.rise = (1.0 + x) * inverse, .bend = inverse * inverse};
  }

  // |form| <= 1: one barrier above, one below.
  [[nodiscard]] Slopes within(const SimdPair& form, Sum& sum) const noexcept {
    const SimdPair z_above = 1.0 - form;
    const SimdPair z_under = 1.0 + form;
    const SimdPair m_above = z_above.max(relaxed_);
    const SimdPair m_under = z_under.max(relaxed_);
    const SimdPair both = m_above * m_under;
    const SimdPair inverse = 1.0 / both;
    const SimdPair above = inverse * m_under;
    const SimdPair under = inverse * m_above;
    const SimdPair x = (m_above - z_above) * above;
    const SimdPair y = (m_under - z_under) * under;
    sum.product *= both;
    sum.rest += x + y + 0.5 * (x * x + y * y);
    return {.rise = (1.0 + x) * above - (1.0 + y) * under, .bend = above * above + under * under};
  }

 private:
  double relaxed_;
};

}  // namespace kerf::lookahead
