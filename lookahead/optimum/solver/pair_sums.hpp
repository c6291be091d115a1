// What two cells add to the merit of the time optimum.
#pragma once

#include <cstddef>

#include "lookahead/optimum/solver/band_system.hpp"
#include "lookahead/optimum/solver/barrier.hpp"
#include "lookahead/optimum/solver/limit_rows.hpp"
#include "lookahead/optimum/solver/walls.hpp"

namespace kerf::lookahead {

// Of a linear form over the three coefficients of a cell.
struct LaneRow {
  Lanes r0;
  Lanes r1;
  Lanes r2;
};

// What two cells add to the merit and to the Newton system. A form over fewer coefficients costs
// less.
class PairSums {
 public:
  PairSums(const CellPair& pair, const double* coefficients, std::size_t cells, const Walls& walls)
      : pair_(&pair),
        c0_(coefficients[0], coefficients[1]),
        c1_(coefficients[1], coefficients[2]),
        c2_(coefficients[2], coefficients[cells == kLanes ? 3 : 2]),
        begin_(c1_ + pair.begin * (c0_ - c1_)),
        middle_(pair.middle[0] * c0_ + pair.middle[1] * c1_ + pair.middle[2] * c2_),
        end_(c1_ + pair.end * (c2_ - c1_)),
        barrier_(walls.relaxed),
        weight_s_(walls.weight_s),
        stiffness_s_(walls.stiffness_s) {}

  [[nodiscard]] bool are_positive() const { return (begin_.min(middle_).min(end_) > 0.0).all(); }
  [[nodiscard]] Lanes walls() const { return wall_.value(); }

  // Returns the time.
  Lanes add_time() {
    const Lanes inverse = 1.0 / middle_;
    const Lanes t = pair_->length_mm * inverse * middle_.sqrt();
    const Lanes slope = -0.5 * t * inverse;
    add({pair_->middle[0], pair_->middle[1], pair_->middle[2]}, slope, -1.5 * slope * inverse);
    return t;
  }
  // Returns the row behind those of the pair.
  const Lanes* add_limits(const Lanes* row) {
    const CellPair& pair = *pair_;
    add_middle(pair.cap, barrier_.below(c1_ * pair.cap, wall_));
    for (int k = 0; k < pair.caps; ++k, row += 2) {
      add_first(row[0], row[1], barrier_.below(row[0] * c0_ + row[1] * c1_, wall_));
    }
    for (int k = 0; k < pair.accelerations; ++k, row += 2) {
      add_first(row[0], row[1], barrier_.within(row[0] * c0_ + row[1] * c1_, wall_));
    }
    for (int k = 0; k < pair.end_accelerations; ++k, row += 2) {
      add_last(row[0], row[1], barrier_.within(row[0] * c1_ + row[1] * c2_, wall_));
    }
    row = add_jerks(row, pair.jerks, begin_, {pair.begin, 1.0 - pair.begin, Lanes::Zero()});
    return add_jerks(row, pair.end_jerks, end_, {Lanes::Zero(), 1.0 - pair.end, pair.end});
  }
  // Into the rows of as many cells as there are.
  void store(std::size_t at, std::size_t cells, BandSystem& system) const {
    for (std::size_t lane = 0; lane < cells; ++lane) {
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
  const Lanes* add_jerks(const Lanes* row, int jerks, const Lanes& squared, const LaneRow& value) {
    if (jerks == 0) {
      return row;
    }
    const Lanes v = squared.sqrt();
    const Lanes half = 0.5 / v;  // of sqrt(b)
    for (int k = 0; k < jerks; ++k, row += 3) {
      const Lanes linear = row[0] * c0_ + row[1] * c1_ + row[2] * c2_;
      const Barrier::Slopes wall = barrier_.within(v * linear, wall_);
      const Lanes by_root = half * linear;
      add({v * row[0] + by_root * value.r0, v * row[1] + by_root * value.r1,
           v * row[2] + by_root * value.r2},
          weight_s_ * wall.rise, stiffness_s_ * wall.bend);
    }
    return row;
  }
  void add(const LaneRow& row, const Lanes& rise, const Lanes& bend) {
    const Lanes b0 = bend * row.r0;
    const Lanes b1 = bend * row.r1;
    const Lanes b2 = bend * row.r2;
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
  void add_first(const Lanes& r0, const Lanes& r1, const Barrier::Slopes& wall) {
    const Lanes rise = weight_s_ * wall.rise;
    const Lanes b0 = stiffness_s_ * wall.bend * r0;
    const Lanes b1 = stiffness_s_ * wall.bend * r1;
    g0_ += rise * r0;
    g1_ += rise * r1;
    d0_ += b0 * r0;
    d1_ += b1 * r1;
    f0_ += b0 * r1;
  }
  void add_last(const Lanes& r1, const Lanes& r2, const Barrier::Slopes& wall) {
    const Lanes rise = weight_s_ * wall.rise;
    const Lanes b1 = stiffness_s_ * wall.bend * r1;
    const Lanes b2 = stiffness_s_ * wall.bend * r2;
    g1_ += rise * r1;
    g2_ += rise * r2;
    d1_ += b1 * r1;
    d2_ += b2 * r2;
    f1_ += b1 * r2;
  }
  void add_middle(const Lanes& r1, const Barrier::Slopes& wall) {
    g1_ += weight_s_ * wall.rise * r1;
    d1_ += stiffness_s_ * wall.bend * r1 * r1;
  }

  const CellPair* pair_;
  Lanes c0_;
  Lanes c1_;
  Lanes c2_;
  Lanes begin_;
  Lanes middle_;
  Lanes end_;
  Barrier barrier_;
  double weight_s_;
  double stiffness_s_;
  Barrier::Sum wall_;
  // Of the Newton system: gradient, diagonal, the bands beside it.
  Lanes g0_ = Lanes::Zero();
  Lanes g1_ = Lanes::Zero();
  Lanes g2_ = Lanes::Zero();
  Lanes d0_ = Lanes::Zero();
  Lanes d1_ = Lanes::Zero();
  Lanes d2_ = Lanes::Zero();
  Lanes f0_ = Lanes::Zero();
  Lanes f1_ = Lanes::Zero();
  Lanes s_ = Lanes::Zero();
};

}  // namespace kerf::lookahead
