#include "lookahead/optimum/merit.hpp"

#include <algorithm>
#include <cmath>

#include "lookahead/optimum/merit_sums.hpp"

namespace kerf::lookahead {

namespace {

std::vector<double> spline_lengths(const Stretch& stretch) {
  std::vector<double> lengths(stretch.spline_cells());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    lengths[i] = stretch.cells[i + stretch.first_spline_cell()].length_mm;
  }
  return lengths;
}

// The limits at one place, as forms over the coefficients.
template <typename Sum>
class Place {
 public:
  Place(const SquaredFeed& feed, const Basis& basis, Sum& sum)
      : feed_(&feed), basis_(&basis), sum_(&sum), v_mm_s_(std::sqrt(feed.value)) {}

  void feedrate(double cap_mm_s) {
    const double inverse = 1.0 / (cap_mm_s * cap_mm_s);
    sum_->below(feed_->value * inverse, scaled(basis_->value, inverse));
  }

  // slope b' + value b
  struct AccelerationForm {
    double slope = 0.0;
    double value = 0.0;
  };
  void acceleration(const AccelerationForm& form, double limit) {
    const double inverse = 1.0 / limit;
    const double slope = form.slope * inverse;
    const double value = form.value * inverse;
    Row row{};
    if constexpr (Sum::kDerives) {
      for (std::size_t k = 0; k < 3; ++k) {
        row[k] = slope * basis_->slope[k] + value * basis_->value[k];
      }
    }
    sum_->within(slope * feed_->slope + value * feed_->value, row);
  }

  // sqrt(b) (bend b'' + slope b' + value b)
  struct JerkForm {
    double bend = 0.0;
    double slope = 0.0;
    double value = 0.0;
  };
  void jerk(const JerkForm& form, double limit) {
    const double scale = v_mm_s_ / limit;
    const double linear =
        scale * (form.bend * feed_->bend + form.slope * feed_->slope + form.value * feed_->value);
    Row row{};
    if constexpr (Sum::kDerives) {
      const double by_root = 0.5 * linear / feed_->value;  // of sqrt(b)
      for (std::size_t k = 0; k < 3; ++k) {
        row[k] = scale * (form.bend * basis_->bend[k] + form.slope * basis_->slope[k]) +
                 (scale * form.value + by_root) * basis_->value[k];
      }
    }
    sum_->within(linear, row);
  }

 private:
  static Row scaled(const Row& row, double factor) {
    return {row[0] * factor, row[1] * factor, row[2] * factor};
  }

  const SquaredFeed* feed_;
  const Basis* basis_;
  Sum* sum_;
  double v_mm_s_;
};

template <typename Sum>
void add_limits(Place<Sum>& place, const Cell& cell, const CellEnd& end, const PlanLimits& limits) {
  place.feedrate(cell.shares.feedrate * end.feedrate_mm_s);
  const profiles::RampLimits& along = cell.along;
  if (std::isfinite(along.acceleration_mm_s2)) {
    place.acceleration({.slope = 0.5}, cell.shares.acceleration * along.acceleration_mm_s2);
  }
  if (std::isfinite(along.jerk_mm_s3)) {
    place.jerk({.bend = 0.5}, cell.shares.jerk * along.jerk_mm_s3);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const MotionLimits& axis = limits.axes[k];
    const double q1 = end.first[k];
    const double q2 = end.second_per_mm[k];
    const double q3 = end.third_per_mm2[k];
    if (q1 == 0.0 && q2 == 0.0 && q3 == 0.0) {
      continue;
    }
    if (std::isfinite(axis.acceleration_mm_s2)) {
      place.acceleration({.slope = 0.5 * q1, .value = q2},
                         cell.shares.acceleration * axis.acceleration_mm_s2);
    }
    if (std::isfinite(axis.jerk_mm_s3)) {
      place.jerk({.bend = 0.5 * q1, .slope = 1.5 * q2, .value = q3},
                 cell.shares.jerk * axis.jerk_mm_s3);
    }
  }
}

double square(double x) {
  return x * x;
}

}  // namespace

double Merit::rest_jerk_mm_s3(const Cell& cell, const CellEnd& end, const PlanLimits& limits) {
  double jerk = cell.along.jerk_mm_s3;
  for (std::size_t k = 0; k < 3; ++k) {
    if (end.first[k] != 0.0) {
      jerk = std::min(jerk, limits.axes[k].jerk_mm_s3 / std::abs(end.first[k]));
    }
  }
  return cell.shares.jerk * jerk;
}

// With s = J t^3 / 6: v^2 = J^(2/3) (6 s)^(4/3) / 4.
Merit::RestCell Merit::rest_cell(const Cell& cell, const RestEnds& ends,
                                 double neighbour_mm) const {
  const double h = cell.length_mm;
  const double jerk = rest_jerk_mm_s3(cell, *ends.rest, *limits_);
  return {.length_mm = h,
          .cap = std::min(0.25 * square(std::cbrt(jerk * square(6.0 * h))),
                          square(cell.shares.feedrate * ends.inner->feedrate_mm_s)),
          .gain = 1.0 / (1.0 + 2.0 * neighbour_mm / (3.0 * h))};
}

Merit::Merit(const Stretch& stretch, const PlanLimits& limits)
    : stretch_(&stretch), limits_(&limits) {
  const std::vector<double> lengths = spline_lengths(stretch);
  basis_ = feed_basis(lengths);
  const std::vector<Cell>& cells = stretch.cells;
  if (stretch.begin.at_rest()) {
    launch_ = rest_cell(cells.front(), {.rest = &cells.front().begin, .inner = &cells.front().end},
                        lengths.front());
  }
  landing_ = rest_cell(cells.back(), {.rest = &cells.back().end, .inner = &cells.back().begin},
                       lengths.back());
}

BandSystem::Rows Merit::free_rows() const noexcept {
  return {.begin = stretch_->begin.at_rest() ? 1U : 2U, .end = size() - 1};
}

void Merit::bind(std::vector<double>& coefficients) const noexcept {
  const StretchBegin& begin = stretch_->begin;
  if (begin.at_rest()) {
    coefficients.front() = launch_.gain * coefficients[1];
  } else {
    coefficients[0] = square(begin.v_mm_s);
    coefficients[1] = coefficients[0] + begin.a_mm_s2 * stretch_->cells.front().length_mm;
  }
  coefficients.back() = landing_.gain * coefficients[size() - 2];
}

void Merit::bind_change(std::vector<double>& change) const noexcept {
  if (stretch_->begin.at_rest()) {
    change.front() = launch_.gain * change[1];
  } else {
    change[0] = change[1] = 0.0;
  }
  change.back() = landing_.gain * change[size() - 2];
}

template <typename Sum>
bool Merit::visit(const std::vector<double>& coefficients, Sum& sum) const {
  const std::size_t count = basis_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Cell& cell = stretch_->cells[i + stretch_->first_spline_cell()];
    const double* c = &coefficients[i];
    const CellBasis& basis = basis_[i];
    const SquaredFeed begin = basis.begin.at(c);
    const SquaredFeed middle = basis.middle.at(c);
    const SquaredFeed end = basis.end.at(c);
    if (!(begin.value > 0.0 && middle.value > 0.0 && end.value > 0.0)) {
      return false;
    }
    sum.time(cell.length_mm, middle.value, basis.middle.value);
    // The spline lies below its coefficients, so between the ends of a cell the cap holds too.
    const double cap = 0.5 * square(cell.shares.feedrate) *
                       (square(cell.begin.feedrate_mm_s) + square(cell.end.feedrate_mm_s));
    sum.below(c[1] / cap, {0.0, 1.0 / cap, 0.0});
    Place<Sum> first(begin, basis.begin, sum);
    add_limits(first, cell, cell.begin, *limits_);
    Place<Sum> last(end, basis.end, sum);
    add_limits(last, cell, cell.end, *limits_);
    const auto add_rest = [&](const RestCell& rest, const SquaredFeed& feed, const Basis& at) {
      sum.time(3.0 * rest.length_mm, feed.value, at.value);
      const double inverse = 1.0 / rest.cap;
      sum.below(feed.value * inverse,
                {at.value[0] * inverse, at.value[1] * inverse, at.value[2] * inverse});
    };
    if (i == 0 && launch_.length_mm > 0.0) {
      add_rest(launch_, begin, basis.begin);
    }
    if (i + 1 == count) {
      add_rest(landing_, end, basis.end);
    }
    sum.end_cell(i);
  }
  return true;
}

double Merit::value(const std::vector<double>& coefficients, const Walls& walls) const {
  ValueSum sum(walls);
  return visit(coefficients, sum) ? sum.value() : kUnbounded;
}

void Merit::derive(const std::vector<double>& coefficients, const Walls& walls,
                   BandSystem& system) const {
  system.clear(size());
  SystemSum sum(walls, system);
  visit(coefficients, sum);
  const std::size_t last = size() - 1;
  const auto fold = [&system](std::size_t outer, std::size_t inner, std::size_t band, double gain) {
    system.gradient[inner] += gain * system.gradient[outer];
    system.diagonal[inner] += gain * (2.0 * system.first[band] + gain * system.diagonal[outer]);
  };
  if (stretch_->begin.at_rest()) {
    fold(0, 1, 0, launch_.gain);
    system.first[1] += launch_.gain * system.second[0];
  }
  fold(last, last - 1, last - 1, landing_.gain);
  system.first[last - 2] += landing_.gain * system.second[last - 2];
}

}  // namespace kerf::lookahead
