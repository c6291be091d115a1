#include "lookahead/optimum/solver/optimal_feed.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kFirstGuess = 0.3;  // of the estimate's squared feedrate
// All barriers together, over the time: the first and the last of kStages. What they take off the
// feedrate is some times as much of the time; where that is ticks, as at low feedrates, stages
// follow until it is less than kLost of one.
constexpr double kFirstShare = 1e-1;
constexpr double kLastShare = 1e-4;
constexpr int kStages = 7;
constexpr double kLost = 0.25;
constexpr double kSame = 1.001;
// Of the slack that a barrier of a typical multiplier keeps: one whose limit, raised by a part,
// takes as much off the time of its cell.
constexpr double kRelaxed = 1.0;
constexpr int kStepsOfStage = 15;
// Of the barriers, what is left to gain when a stage ends: Newton decrement.
constexpr double kStageDone = 0.1;
constexpr double kRoughly = 0.5;  // of one that is not the last
constexpr int kHalvings = 25;
constexpr int kDampings = 6;
constexpr double kFirstDamping = 1e-13;  // of the diagonal
constexpr double kMoreDamping = 100.0;
constexpr double kArmijo = 1e-4;
constexpr double kToZero = 0.9;  // of the way, in one step

class Search {
 public:
  Search(const CellSequence& sequence, const PlanLimits& limits, OptimalFeed& feed)
      : objective_(sequence, limits), feed_(&feed) {}
  // feed: of the range, with the mean of the whole.
  Search(const CellSequence& sequence, const PlanLimits& limits, const SplineRange& range,
         OptimalFeed& feed)
      : objective_(sequence, limits, range), feed_(&feed), is_part_(true) {}

  [[nodiscard]] const BarrierObjective& objective() const { return objective_; }
  // At the coefficients of the latest stage.
  [[nodiscard]] double time_s() const { return time_s_; }

  struct Goal {
    double share = 0.0;  // of all barriers in the time
    double done = 0.0;   // what may be left to gain, a part of the barriers
  };

  // Newton steps until no more is left to gain.
  void stage(const Goal& goal) {
    begin(goal.share);
    for (int k = 0; k < kStepsOfStage; ++k) {
      if (step_ends(goal)) {
        return;
      }
    }
  }

 private:
  // The system of a stage at its first place.
  //
  // Where the stage before has ended, the force of each barrier that matters is its weight over the
  // slack, and the slack has to shrink as the weight does. With the second derivatives of the
  // barriers of the new weight, which are so much smaller, a Newton step goes that many times too
  // far; with those of the old weight it goes there (it is the step of a primal-dual method
  // [Nocedal, chapter 19]). So the first step of a stage takes these.
  void begin(double share) {
    if (!is_part_) {
      if (time_s_ == 0.0) {
        time_s_ = objective_.value(feed_->coefficients, {.relaxed = 1.0}).time_s;
      }
      feed_->mean_s = time_s_ / static_cast<double>(objective_.size());
    }
    const double share_before = share_ > 0.0 ? share_ : share;
    share_ = share;
    weights_ = {.weight_s = share * feed_->mean_s,
                .stiffness_s = share_before * feed_->mean_s,
                .relaxed = kRelaxed * share};
    value_s_ = objective_.derive(feed_->coefficients, weights_, system_).objective_s;
    weights_.stiffness_s = weights_.weight_s;
  }

  // A step; whether the stage ends with it: no more is left to gain, or the search is stuck.
  bool step_ends(const Goal& goal) {
    const BandSystem::Rows rows = objective_.free_rows();
    if (!solve(rows)) {
      return true;
    }
    ++feed_->newton_steps;
    double slope = 0.0;
    for (std::size_t i = rows.begin; i < rows.end; ++i) {
      slope += system_.gradient[i] * change_[i];
    }
    objective_.bind_change(change_);
    const double least_s = goal.done * weights_.weight_s * static_cast<double>(objective_.size());
    const bool is_last = -slope < least_s;
    double length = 1.0;
    for (int k = 0; k < kHalvings; ++k) {
      try_step(length);
      // What is derived after the last step would have this stage's weights.
      const BarrierObjective::Value now = is_last ? objective_.value(trial_, weights_)
                                                  : objective_.derive(trial_, weights_, system_);
      if (now.objective_s <= value_s_ + kArmijo * length * slope) {
        feed_->coefficients.swap(trial_);
        value_s_ = now.objective_s;
        time_s_ = now.time_s;
        return is_last;
      }
      length *= 0.5;
    }
    return true;
  }

  // Each coefficient by itself: one that falls steeply would hold up all others.
  void try_step(double length) {
    const std::vector<double>& c = feed_->coefficients;
    trial_.resize(c.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
      trial_[i] = std::max(c[i] + length * change_[i], (1.0 - kToZero) * c[i]);
    }
  }

  // BarrierWeights of very different steepness leave the system positive definite by less than
  // rounding takes away: then a little is added to its diagonal.
  bool solve(const BandSystem::Rows& rows) {
    change_.assign(objective_.size(), 0.0);
    if (system_.solve(rows, change_)) {
      return true;
    }
    double damping = kFirstDamping;
    for (int k = 0; k < kDampings; ++k) {
      static_cast<void>(objective_.derive(feed_->coefficients, weights_, system_));
      for (double& d : system_.diagonal) {
        d *= 1.0 + damping;
      }
      if (system_.solve(rows, change_)) {
        return true;
      }
      damping *= kMoreDamping;
    }
    return false;
  }

  BarrierObjective objective_;
  OptimalFeed* feed_;
  bool is_part_ = false;
  BandSystem system_;
  BarrierWeights weights_{};
  double share_ = 0.0;    // of the weights; 0: none yet
  double value_s_ = 0.0;  // of the objective at the coefficients, renewed as the system is
  double time_s_ = 0.0;   // at the coefficients; 0: not known yet
  std::vector<double> change_;
  std::vector<double> trial_;
};

std::vector<double> first_guess(const CellSequence& sequence, const PlanLimits& limits) {
  assert(sequence.spline_cells() >= 2);
  const std::vector<double> feeds = estimate_feeds(
      sequence.cells,
      {.v_begin_mm_s = sequence.begin.at_rest() ? 0.0 : sequence.begin.v_mm_s, .v_end_mm_s = 0.0},
      limits);
  const std::size_t first = sequence.first_spline_cell();
  const std::size_t count = sequence.spline_cells();
  std::vector<double> coefficients(count + 2);
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    // Between the ends of the cell in whose middle the coefficient stands; at the outer knots.
    const double begin = feeds[first + std::min(i > 0 ? i - 1 : 0, count)];
    const double end = feeds[first + std::min(i, count)];
    coefficients[i] = kFirstGuess * std::min(begin * begin, end * end);
    if (i > 0 && i <= count) {
      coefficients[i] = std::max(coefficients[i], sequence.cells[first + i - 1].planned_squared);
    }
  }
  return coefficients;
}

}  // namespace

std::vector<double> first_feed(const CellSequence& sequence, const PlanLimits& limits) {
  std::vector<double> coefficients = first_guess(sequence, limits);
  BarrierObjective(sequence, limits).bind(coefficients);
  return coefficients;
}

OptimalFeed find_optimal_feed(const CellSequence& sequence, const PlanLimits& limits) {
  OptimalFeed feed;
  feed.coefficients = first_guess(sequence, limits);
  Search search(sequence, limits, feed);
  search.objective().bind(feed.coefficients);
  const auto share_of = [](int stage) {
    return kFirstShare * std::pow(kLastShare / kFirstShare, stage / (kStages - 1.0));
  };
  int stage = 0;
  for (; stage + 1 < kStages; ++stage) {
    search.stage({.share = share_of(stage), .done = kRoughly});
  }
  feed.last_share = std::min(kLastShare, kLost * limits.period_s / search.time_s());
  for (; share_of(stage) > kSame * feed.last_share; ++stage) {
    search.stage({.share = share_of(stage), .done = kRoughly});
  }
  search.stage({.share = feed.last_share, .done = kStageDone});
  return feed;
}

int refine_optimal_feed(const CellSequence& sequence, const PlanLimits& limits,
                        const SplineRange& range, OptimalFeed& feed) {
  const auto begin = feed.coefficients.begin() + static_cast<std::ptrdiff_t>(range.begin);
  OptimalFeed part{.coefficients = {begin, begin + static_cast<std::ptrdiff_t>(range.size() + 2)},
                   .mean_s = feed.mean_s,
                   .last_share = feed.last_share};
  Search search(sequence, limits, range, part);
  search.objective().bind(part.coefficients);
  search.stage({.share = feed.last_share, .done = kStageDone});
  std::ranges::copy(part.coefficients, begin);
  return part.newton_steps;
}

}  // namespace kerf::lookahead
