// The contribution of two cells to the objective of the time optimum.
#pragma once

#include <cstddef>

#include "lookahead/optimum/solver/band_system.hpp"
#include "lookahead/optimum/solver/barrier.hpp"
#include "lookahead/optimum/solver/limit_rows.hpp"

namespace kerf::lookahead {

// Of a linear form over the three coefficients of a cell.
struct SimdRow {
  SimdPair r0;
  SimdPair r1;
  SimdPair r2;
};

// The contribution of two cells to the objective and, with its derivatives, to the Newton system. A
// form over fewer coefficients costs less.
template <Order kOrder>
class PairSums {
 public:
  PairSums(const CellPair& pair, const double* coefficients, std::size_t cells,
           const BarrierWeights& weights)
      : pair_(&pair),
        cells_(cells),
        c0_(coefficients[0], coefficients[1]),
        c1_(coefficients[1], coefficients[2]),
        c2_(coefficients[2], coefficients[cells == kSimdWidth ? 3 : 2]),
        begin_(c1_ + pair.begin * (c0_ - c1_)),
        middle_(pair.middle[0] * c0_ + pair.middle[1] * c1_ + pair.middle[2] * c2_),
        end_(c1_ + pair.end * (c2_ - c1_)),
        barrier_(weights.relaxed),
        weight_s_(weights.weight_s),
        stiffness_s_(weights.stiffness_s) {}

  [[nodiscard]] bool are_positive() const { return (begin_.min(middle_).min(end_) > 0.0).all(); }
  [[nodiscard]] SimdPair barrier() const { return barrier_sum_.value(); }

  // Returns the time.
  SimdPair add_time() {
    const SimdPair inverse = 1.0 / middle_;
    SimdPair t = pair_->length_mm * inverse * middle_.sqrt();
    const SimdPair slope = -0.5 * t * inverse;
    add({pair_->middle[0], pair_->middle[1], pair_->middle[2]}, {slope, -1.5 * slope * inverse});
    return t;
  }
  // Returns the row after those of the pair.
  const SimdPair* add_limits(const SimdPair* row) {
    const CellPair& pair = *pair_;
    add_middle(pair.cap, barrier_.below(c1_ * pair.cap, barrier_sum_));
    for (int k = 0; k < pair.caps; ++k, row += 2) {
      add_first(row[0], row[1], barrier_.below(row[0] * c0_ + row[1] * c1_, barrier_sum_));
    }
    for (int k = 0; k < pair.accelerations; ++k, row += 2) {
      add_first(row[0], row[1], barrier_.within(row[0] * c0_ + row[1] * c1_, barrier_sum_));
    }
    for (int k = 0; k < pair.end_accelerations; ++k, row += 2) {
      add_last(row[0], row[1], barrier_.within(row[0] * c1_ + row[1] * c2_, barrier_sum_));
    }
    row = add_jerks(row, pair.jerks, begin_, {pair.begin, 1.0 - pair.begin, SimdPair::Zero()});
    row = add_jerks(row, pair.end_jerks, end_, {SimdPair::Zero(), 1.0 - pair.end, pair.end});
    row = add_jump_jerks(row, pair.jump_jerks, begin_,
                         {pair.begin, 1.0 - pair.begin, SimdPair::Zero()});
    return add_jump_jerks(row, pair.end_jump_jerks, end_,
                          {SimdPair::Zero(), 1.0 - pair.end, pair.end});
  }
  // Into the rows of as many cells as there are.
  void store(std::size_t at, BandSystem& system) const requires(kOrder == Order::derivatives) {
    for (std::size_t lane = 0; lane < cells_; ++lane) {
      const auto l = static_cast<Eigen::Index>(lane);
      const std::size_t i = at + lane;
      system.gradient[i] += g0_[l];
      system.gradient[i + 1] += g1_[l];
      system.gradient[i + 2] += g2_[l];
      system.diagonal[i] += d0_[l];
      system.diagonal[i + 1] += d1_[l];
      system.diagonal[i + 2] += d2_[l];
      system.first[i] += f0_[l];
      system.first[i + 1] += f1_[l];
      system.second[i] += s_[l];
    }
  }

 private:
  // squared: v^2 at the place of the rows, value: over the coefficients.
  const SimdPair* add_jerks(const SimdPair* row, int jerks, const SimdPair& squared,
                            const SimdRow& value) {
    if (jerks == 0) {
      return row;
    }
    const SimdPair v = squared.sqrt();
    const SimdPair half = 0.5 / v;  // of sqrt(b)
    for (int k = 0; k < jerks; ++k, row += 3) {
      const SimdPair linear = row[0] * c0_ + row[1] * c1_ + row[2] * c2_;
      const Barrier::Slopes slopes = barrier_.within(v * linear, barrier_sum_);
      const SimdPair by_root = half * linear;
      add({v * row[0] + by_root * value.r0, v * row[1] + by_root * value.r1,
           v * row[2] + by_root * value.r2},
          {weight_s_ * slopes.rise, stiffness_s_ * slopes.bend});
    }
    return row;
  }
  // With a jump's part of the limit, which is linear in the coefficients.
  const SimdPair* add_jump_jerks(const SimdPair* row, int jerks, const SimdPair& squared,
                                 const SimdRow& value) {
    if (jerks == 0) {
      return row;
    }
    const SimdPair v = squared.sqrt();
    const SimdPair half = 0.5 / v;
    for (int k = 0; k < jerks; ++k, row += 4) {
      const SimdPair linear = row[0] * c0_ + row[1] * c1_ + row[2] * c2_;
      const SimdPair by_root = half * linear;
      const SimdRow moved{v * row[0] + by_root * value.r0, v * row[1] + by_root * value.r1,
                          v * row[2] + by_root * value.r2};
      const SimdRow jump{row[3] * value.r0, row[3] * value.r1, row[3] * value.r2};
      const Barrier::Slopes above = barrier_.below(row[3] * squared + v * linear, barrier_sum_);
      add({jump.r0 + moved.r0, jump.r1 + moved.r1, jump.r2 + moved.r2},
          {weight_s_ * above.rise, stiffness_s_ * above.bend});
      const Barrier::Slopes under = barrier_.below(row[3] * squared - v * linear, barrier_sum_);
      add({jump.r0 - moved.r0, jump.r1 - moved.r1, jump.r2 - moved.r2},
          {weight_s_ * under.rise, stiffness_s_ * under.bend});
    }
    return row;
  }
  void add(const SimdRow& row, const Barrier::Slopes& slopes) {
    if constexpr (kOrder == Order::value) {
      return;
    }
    const auto& [rise, bend] = slopes;
    const SimdPair b0 = bend * row.r0;
    const SimdPair b1 = bend * row.r1;
    const SimdPair b2 = bend * row.r2;
    g0_ += rise * row.r0;
    g1_ += rise * row.r1;
    g2_ += rise * row.r2;
    d0_ += b0 * row.r0;
    d1_ += b1 * row.r1;
    d2_ += b2 * row.r2;
    f0_ += b0 * row.r1;
    f1_ += b1 * row.r2;
    s_ += b0 * row.r2;
  }
  void add_first(const SimdPair& r0, const SimdPair& r1, const Barrier::Slopes& slopes) {
    if constexpr (kOrder == Order::value) {
      return;
    }
    const SimdPair rise = weight_s_ * slopes.rise;
    const SimdPair b0 = stiffness_s_ * slopes.bend * r0;
    const SimdPair b1 = stiffness_s_ * slopes.bend * r1;
    g0_ += rise * r0;
    g1_ += rise * r1;
    d0_ += b0 * r0;
    d1_ += b1 * r1;
    f0_ += b0 * r1;
  }
  void add_last(const SimdPair& r1, const SimdPair& r2, const Barrier::Slopes& slopes) {
    if constexpr (kOrder == Order::value) {
      return;
    }
    const SimdPair rise = weight_s_ * slopes.rise;
    const SimdPair b1 = stiffness_s_ * slopes.bend * r1;
    const SimdPair b2 = stiffness_s_ * slopes.bend * r2;
    g1_ += rise * r1;
    g2_ += rise * r2;
    d1_ += b1 * r1;
    d2_ += b2 * r2;
    f1_ += b1 * r2;
  }
  void add_middle(const SimdPair& r1, const Barrier::Slopes& slopes) {
    if constexpr (kOrder == Order::value) {
      return;
    }
    g1_ += weight_s_ * slopes.rise * r1;
    d1_ += stiffness_s_ * slopes.bend * r1 * r1;
  }

  const CellPair* pair_;
  std::size_t cells_;  // that there are of the two
  SimdPair c0_;
  SimdPair c1_;
  SimdPair c2_;
  SimdPair begin_;
  SimdPair middle_;
  SimdPair end_;
  Barrier barrier_;
  double weight_s_;
  double stiffness_s_;
  Barrier::Sum barrier_sum_;
  // Of the Newton system: gradient, diagonal, the bands beside it.
  SimdPair g0_ = SimdPair::Zero();
  SimdPair g1_ = SimdPair::Zero();
  SimdPair g2_ = SimdPair::Zero();
  SimdPair d0_ = SimdPair::Zero();
  SimdPair d1_ = SimdPair::Zero();
  SimdPair d2_ = SimdPair::Zero();
  SimdPair f0_ = SimdPair::Zero();
  SimdPair f1_ = SimdPair::Zero();
  SimdPair s_ = SimdPair::Zero();
};

}  // namespace kerf::lookahead
