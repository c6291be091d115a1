// The wall in front of a limit, which the solver feels but may break through.
#pragma once

#include "lookahead/optimum/solver/lanes.hpp"

namespace kerf::lookahead {

// Of a slack z (the share of a limit that is left): -ln z, and below `relaxed` the parabola that
// goes on from there with the same slope and bend (Hauser and Saccon, "A barrier function method
// for the optimization of trajectory functionals with constraints", CDC 2006). It is finite
// everywhere, so the search may begin anywhere; where an optimum keeps more slack than `relaxed`,
// it is that of the logarithm.
//
// Without a branch: with m = max(z, relaxed) and x = (m - z) / m the wall is x + x^2 / 2 - ln m,
// its fall (1 + x) / m and its bend 1 / m^2.
class Barrier {
 public:
  explicit Barrier(double relaxed) noexcept : relaxed_(relaxed) {}

  struct Slopes {
    Lanes rise;  // the first derivative by the form
    Lanes bend;  // the second
  };

  // Of many walls: one logarithm of the product of their slacks. After as many as a cell has it is
  // to be taken, for a product of more might underflow.
  struct Sum {
    Lanes product = Lanes::Ones();
    Lanes rest = Lanes::Zero();

    [[nodiscard]] Lanes value() const { return rest - product.log(); }
  };

  // form <= 1
  [[nodiscard]] Slopes below(const Lanes& form, Sum& sum) const noexcept {
    const Lanes z = 1.0 - form;
    const Lanes m = z.max(relaxed_);
    const Lanes inverse = 1.0 / m;
    const Lanes x = (m - z) * inverse;
    sum.product *= m;
    sum.rest += x + 0.5 * x * x;
    return {.rise = (1.0 + x) * inverse, .bend = inverse * inverse};
  }

  // |form| <= 1: one wall above, one below.
  [[nodiscard]] Slopes within(const Lanes& form, Sum& sum) const noexcept {
    const Lanes z_above = 1.0 - form;
    const Lanes z_under = 1.0 + form;
    const Lanes m_above = z_above.max(relaxed_);
    const Lanes m_under = z_under.max(relaxed_);
    const Lanes both = m_above * m_under;
    const Lanes inverse = 1.0 / both;
    const Lanes above = inverse * m_under;
    const Lanes under = inverse * m_above;
    const Lanes x = (m_above - z_above) * above;
    const Lanes y = (m_under - z_under) * under;
    sum.product *= both;
    sum.rest += x + y + 0.5 * (x * x + y * y);
    return {.rise = (1.0 + x) * above - (1.0 + y) * under, .bend = above * above + under * under};
  }

 private:
  double relaxed_;
};

}  // namespace kerf::lookahead
