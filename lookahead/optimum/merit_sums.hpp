// The two ways to sum up the merit: its value alone, or its Newton system.
#pragma once

#include <array>
#include <cmath>

#include "lookahead/optimum/merit.hpp"

namespace kerf::lookahead {

using Row = std::array<double, 3>;  // of a linear form, over the coefficients of a cell

class ValueSum {
 public:
  static constexpr bool kDerives = false;
  explicit ValueSum(const Walls& walls) : walls_(walls), barrier_(walls.relaxed) {}

  void time(double length_mm, double b, const Row& /*row*/) { time_s_ += length_mm / std::sqrt(b); }
  // form <= 1
  void below(double form, const Row& /*row*/) { barrier_.add(1.0 - form, sum_); }
  // |form| <= 1
  void within(double form, const Row& /*row*/) {
    barrier_.add(1.0 - form, sum_);
    barrier_.add(1.0 + form, sum_);
  }
  // Between cells: a product of many slacks might underflow.
  void end_cell(std::size_t /*cell*/) {
    walls_s_ += sum_.value();
    sum_ = {};
  }

  [[nodiscard]] double value() const { return time_s_ + walls_.weight_s * walls_s_; }

 private:
  Walls walls_;
  Barrier barrier_;
  Barrier::Sum sum_{};
  double time_s_ = 0.0;
  double walls_s_ = 0.0;
};

class SystemSum {
 public:
  static constexpr bool kDerives = true;
  SystemSum(const Walls& walls, BandSystem& system)
      : weight_s_(walls.weight_s), barrier_(walls.relaxed), system_(&system) {}

  void time(double length_mm, double b, const Row& row) {
    const double t = length_mm / std::sqrt(b);
    add(row, -0.5 * t / b, 0.75 * t / (b * b));
  }
  void below(double form, const Row& row) {
    const Barrier::Slopes wall = barrier_.slopes(1.0 - form);
    add(row, weight_s_ * wall.fall, weight_s_ * wall.bend);
  }
  void within(double form, const Row& row) {
    const Barrier::Slopes above = barrier_.slopes(1.0 - form);
    const Barrier::Slopes under = barrier_.slopes(1.0 + form);
    add(row, weight_s_ * (above.fall - under.fall), weight_s_ * (above.bend + under.bend));
  }
  void end_cell(std::size_t cell) {
    for (std::size_t k = 0; k < 3; ++k) {
      system_->gradient[cell + k] += gradient_[k];
      system_->diagonal[cell + k] += diagonal_[k];
    }
    system_->first[cell] += first_[0];
    system_->first[cell + 1] += first_[1];
    system_->second[cell] += second_;
    gradient_ = diagonal_ = {};
    first_ = {};
    second_ = 0.0;
  }

 private:
  void add(const Row& row, double slope, double bend) {
    for (std::size_t k = 0; k < 3; ++k) {
      gradient_[k] += slope * row[k];
      diagonal_[k] += bend * row[k] * row[k];
    }
    first_[0] += bend * row[0] * row[1];
    first_[1] += bend * row[1] * row[2];
    second_ += bend * row[0] * row[2];
  }

  double weight_s_;
  Barrier barrier_;
  BandSystem* system_;
  Row gradient_{};
  Row diagonal_{};
  std::array<double, 2> first_{};
  double second_ = 0.0;
};

}  // namespace kerf::lookahead
