#include <algorithm>
#include <array>
#include <cmath>

#include "lookahead/optimum/solver/limit_check.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kMinSlack = 1e-6;  // what is less is rounding, or a refined cell
constexpr double kClearly = 1.0 + 1e-6;
// A cell with less of the jerk than this has left most of it to the jump beside it.
constexpr double kMaxOfJerk = 0.5;
constexpr double kFarFromAll = 1.0;  // price of a limit that is half used

class Prices {
 public:
  // form: a figure over its limit.
  void add(double form, Constraint limit) {
    price_[static_cast<std::size_t>(limit)] += form / std::max(1.0 - form, kMinSlack);
  }
  [[nodiscard]] Constraint highest() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < price_.size(); ++i) {
      best = price_[i] > kClearly * price_[best] ? i : best;
    }
    return static_cast<Constraint>(best);
  }
  [[nodiscard]] bool are_low() const {
    return *std::max_element(price_.begin(), price_.end()) < kFarFromAll;
  }

 private:
  std::array<double, interp::kConstraints> price_{};
};

bool is_beside_junction(const Cell& cell) {
  return cell.allowed.jerk < kMaxOfJerk;
}

Constraint unless_junction(const Cell& cell, Constraint limit) {
  return is_beside_junction(cell) ? Constraint::junction : limit;
}

void add_place(const Cell& cell, const PathSample& path, const SquaredFeed& feed,
               const PlanLimits& limits, Prices& prices) {
  const double v = std::sqrt(std::max(feed.value, 0.0));
  const profiles::PathMotion motion{
      .v_mm_s = v, .a_mm_s2 = 0.5 * feed.slope, .j_mm_s3 = 0.5 * v * feed.bend};
  const double a_share = cell.shares.acceleration;
  const double j_share = cell.shares.jerk;
  prices.add(v / (cell.shares.feedrate * path.feedrate_mm_s), path.limit);
  prices.add(std::abs(motion.a_mm_s2) / (a_share * cell.along.acceleration_mm_s2),
             unless_junction(cell, cell.along_from.acceleration));
  prices.add(std::abs(motion.j_mm_s3) / (j_share * cell.along.jerk_mm_s3),
             unless_junction(cell, cell.along_from.jerk));
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    const AxisTerms terms = axis_terms(path, k, motion);
    prices.add(std::abs(terms.acceleration_mm_s2()) / (a_share * limits.axes[k].acceleration_mm_s2),
               unless_junction(cell, interp::of_axis(Constraint::x_acceleration, k)));
    const double jumps = cell.jumps_per_mm_s[k] * v * v;
    const double jerk = std::abs(terms.jerk_mm_s3());
    prices.add((jerk + jumps) / (j_share * limits.axes[k].jerk_mm_s3),
               jumps > jerk ? Constraint::junction
                            : unless_junction(cell, interp::of_axis(Constraint::x_jerk, k)));
  }
}

}  // namespace

Constraint tightest_constraint(const Cell& cell, const CellFeed& feed, const PlanLimits& limits) {
  Prices prices;
  add_place(cell, cell.begin, feed.begin, limits, prices);
  add_place(cell, cell.end, feed.end, limits, prices);
  const PathSample& lower =
      cell.begin.feedrate_mm_s < cell.end.feedrate_mm_s ? cell.begin : cell.end;
  const double cap = 0.5 * (cell.begin.feedrate_mm_s * cell.begin.feedrate_mm_s +
                            cell.end.feedrate_mm_s * cell.end.feedrate_mm_s);
  prices.add(std::sqrt(std::max(feed.coefficient, 0.0) / cap) / cell.shares.feedrate, lower.limit);
  // Between two places that a junction holds down nothing else comes near.
  return is_beside_junction(cell) && prices.are_low() ? Constraint::junction : prices.highest();
}

// With s = j t^3 / 6: v = j t^2 / 2, so j = 2 v^3 / (9 s^2).
Constraint tightest_constraint_at_rest(const Cell& cell, double v_mm_s, bool launch,
                                       const PlanLimits& limits) {
  const PathSample& rest = launch ? cell.begin : cell.end;
  const PathSample& moving = launch ? cell.end : cell.begin;
  const double v = v_mm_s;
  const double j = 2.0 * v * v * v / (9.0 * cell.length_mm * cell.length_mm);
  Prices prices;
  prices.add(v / (cell.shares.feedrate * moving.feedrate_mm_s), moving.limit);
  prices.add(j / (cell.shares.jerk * cell.along.jerk_mm_s3),
             unless_junction(cell, cell.along_from.jerk));
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    prices.add(std::abs(rest.first[k]) * j / (cell.shares.jerk * limits.axes[k].jerk_mm_s3),
               unless_junction(cell, interp::of_axis(Constraint::x_jerk, k)));
  }
  return prices.highest();
}

}  // namespace kerf::lookahead
