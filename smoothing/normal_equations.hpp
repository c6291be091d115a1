// The normal equations of a spline's coefficients: symmetric, with five diagonals on each side.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace kerf::smoothing {

inline constexpr std::size_t kFitDegree = 5;
inline constexpr std::size_t kOrder = kFitDegree + 1;

using Powers = Eigen::Matrix<double, kOrder, 1>;

// One row for each coefficient, three right sides. add() and stiffen() first, then fix() what is
// known, then solve().
class FitEquations {
 public:
  explicit FitEquations(std::size_t count)
      : rows_(count, Row::Zero()), right_(count, Eigen::Vector3d::Zero()) {}

  void add(std::size_t first, const Powers& values, double weight, const Eigen::Vector3d& point) {
    for (std::size_t i = 0; i < kOrder; ++i) {
      const double scaled = weight * values[static_cast<Eigen::Index>(i)];
      Row& row = rows_[first + i];
      for (std::size_t j = 0; j <= i; ++j) {
        row[static_cast<Eigen::Index>(kFitDegree - i + j)] +=
            scaled * values[static_cast<Eigen::Index>(j)];
      }
      right_[first + i] += scaled * point;
    }
  }

  // A third difference of coefficients is to be 0.
  void stiffen(std::size_t first, double weight) {
    constexpr std::array<double, 4> kDifference{-1.0, 3.0, -3.0, 1.0};
    for (std::size_t i = 0; i < kDifference.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        rows_[first + i][static_cast<Eigen::Index>(kFitDegree - i + j)] +=
            weight * kDifference[i] * kDifference[j];
      }
    }
  }

  void fix(std::size_t index, const Eigen::Vector3d& value) {
    for (std::size_t j = index >= kFitDegree ? index - kFitDegree : 0; j < index; ++j) {
      double& entry = rows_[index][static_cast<Eigen::Index>(kFitDegree + j - index)];
      right_[j] -= entry * value;
      entry = 0.0;
    }
    const std::size_t last = std::min(index + kFitDegree, rows_.size() - 1);
    for (std::size_t i = index + 1; i <= last; ++i) {
      double& entry = rows_[i][static_cast<Eigen::Index>(kFitDegree + index - i)];
      right_[i] -= entry * value;
      entry = 0.0;
    }
    rows_[index][kFitDegree] = 1.0;
    right_[index] = value;
  }

  std::vector<Eigen::Vector3d> solve() {
    factorise();
    const std::size_t count = rows_.size();
    for (std::size_t i = count; i-- > 0;) {
      right_[i] /= entry(i, i);
      const std::size_t last = std::min(i + kFitDegree, count - 1);
      for (std::size_t j = i + 1; j <= last; ++j) {
        right_[i] -= entry(j, i) * right_[j];
      }
    }
    return std::move(right_);
  }

 private:
  using Row = Eigen::Matrix<double, kOrder, 1>;

  // L D L^T in place, and the right side through L.
  void factorise() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const std::size_t first = i >= kFitDegree ? i - kFitDegree : 0;
      for (std::size_t j = first; j < i; ++j) {
        double sum = entry(i, j);
        const std::size_t from = std::max(first, j >= kFitDegree ? j - kFitDegree : 0);
        for (std::size_t m = from; m < j; ++m) {
          sum -= entry(i, m) * entry(j, m) * entry(m, m);
        }
        entry(i, j) = sum / entry(j, j);
        right_[i] -= entry(i, j) * right_[j];
      }
      for (std::size_t m = first; m < i; ++m) {
        entry(i, i) -= entry(i, m) * entry(i, m) * entry(m, m);
      }
    }
  }

  double& entry(std::size_t i, std::size_t j) {
    return rows_[i][static_cast<Eigen::Index>(kFitDegree + j - i)];
  }
  std::vector<Row> rows_;
  std::vector<Eigen::Vector3d> right_;
};

}  // namespace kerf::smoothing
