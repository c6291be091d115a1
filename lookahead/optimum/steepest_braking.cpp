#include "lookahead/optimum/steepest_braking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "lookahead/optimum/grid/speed_estimate.hpp"
#include "profiles/shape_value.hpp"

namespace kerf::lookahead {

namespace {

// Of the limits of axes: the places between the ends of a step are not looked at.
constexpr double kAimOfSteps = 0.998;
constexpr double kSteps = 150.0;  // of the whole way, about
constexpr std::size_t kMaxSteps = 250;
constexpr int kRounds = 3;  // for where a step of this jerk ends
// Of the limit of jerk, until a landing keeps all limits.
constexpr std::array<double, 3> kLandings{0.9, 0.6, 0.35};

struct Linear {
  double factor = 1.0;
  double constant = 0.0;
};

struct Range {
  double low = -kUnbounded;
  double high = kUnbounded;

  // Those x for which |factor x + constant| <= bound.
  void narrow(const Linear& term, double bound) {
    if (term.factor == 0.0) {
      return;
    }
    const double centre = -term.constant / term.factor;
    const double half = bound / std::abs(term.factor);
    low = std::max(low, centre - half);
    high = std::min(high, centre + half);
  }
  void narrow(const Range& other) {
    low = std::max(low, other.low);
    high = std::min(high, other.high);
  }
};

class Steps {
 public:
  Steps(const StartState& begin, const WayAhead& way, const PlanLimits& limits, double landing)
      : way_(&way),
        path_(way.path()),
        limits_(&limits),
        landing_(landing),
        now_{.v_mm_s = begin.v_mm_s, .a_mm_s2 = begin.a_mm_s2} {}

  std::optional<std::vector<profiles::CellLaw>> to_rest() {
    const Cell& first = way_->cells().front();
    const double a_mm_s2 = tangential_acceleration_mm_s2(first, first.begin, *limits_);
    const double j_mm_s3 = tangential_jerk_mm_s3(first, first.begin, *limits_);
    const double whole_s = now_.v_mm_s / a_mm_s2 + a_mm_s2 / j_mm_s3;
    step_s_ = std::max(limits_->period_s, whole_s / kSteps);
    for (std::size_t i = 0; i < kMaxSteps; ++i) {
      const auto place = at(now_.s_mm);
      if (!place) {
        return std::nullopt;
      }
      if (lands(*place)) {
        laws_.push_back(
            profiles::CellLaw::landing(now_.v_mm_s, now_.v_mm_s * landing_s(now_) / 3.0));
        return std::move(laws_);
      }
      if (!go_on(*place)) {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

 private:
  struct Place {
    const Cell* cell = nullptr;
    PathSample path{};
    std::size_t index = 0;  // of the cell
  };

  // Nothing: it lies after what is known.
  [[nodiscard]] std::optional<Place> at(double s_mm) const {
    const auto place = way_->place_at({.way_mm = s_mm, .from = cell_});
    if (!place) {
      return std::nullopt;
    }
    const Cell& cell = way_->cells()[place->cell];
    return Place{.cell = &cell, .path = path_(cell, place->s_mm), .index = place->cell};
  }

  // The jerk that leads to rest in 2 v / |a|.
  static double landing_jerk_mm_s3(const profiles::PathMotion& from) {
    return 0.5 * from.a_mm_s2 * from.a_mm_s2 / from.v_mm_s;
  }
  static double landing_s(const profiles::PathMotion& from) {
    return 2.0 * from.v_mm_s / -from.a_mm_s2;
  }

  [[nodiscard]] bool lands(const Place& place) const {
    if (now_.a_mm_s2 >= 0.0) {
      return false;
    }
    profiles::PathMotion next = now_;
    next.v_mm_s += now_.a_mm_s2 * step_s_;
    return next.v_mm_s <= 0.0 ||
           landing_jerk_mm_s3(next) >
               landing_ * tangential_jerk_mm_s3(*place.cell, place.path, *limits_);
  }

  // Where the motion has had the jerk for a time since `now_`, which changes its acceleration.
  [[nodiscard]] Range jerks(const Place& place, double v_mm_s, double time_s) const {
    Range range;
    range.narrow(Linear{}, place.cell->allowed.jerk * place.cell->along.jerk_mm_s3);
    const profiles::PathMotion motion{.v_mm_s = v_mm_s, .a_mm_s2 = now_.a_mm_s2};
    const double aim = kAimOfSteps * place.cell->allowed.jerk;
    for (std::size_t k = 0; k < limits_->axes.size(); ++k) {
      const AxisTerms terms = axis_terms(place.path, k, motion);
      const double by_time = 3.0 * place.path.second_per_mm[k] * v_mm_s * time_s;
      const double jumps = place.cell->jumps_per_mm_s[k] * v_mm_s * v_mm_s;
      range.narrow({.factor = place.path.first[k] + by_time,
                    .constant = terms.cross_mm_s3 + terms.third_mm_s3},
                   aim * limits_->axes[k].jerk_mm_s3 - jumps);
    }
    return range;
  }

  [[nodiscard]] Range accelerations(const Place& place, const profiles::PathMotion& motion) const {
    Range range;
    range.narrow(Linear{}, place.cell->allowed.acceleration * place.cell->along.acceleration_mm_s2);
    const double aim = kAimOfSteps * place.cell->allowed.acceleration;
    for (std::size_t k = 0; k < limits_->axes.size(); ++k) {
      range.narrow({.factor = place.path.first[k],
                    .constant = axis_terms(place.path, k, motion).centripetal_mm_s2},
                   aim * limits_->axes[k].acceleration_mm_s2);
    }
    return range;
  }

  [[nodiscard]] profiles::PathMotion end_of_step(double jerk_mm_s3) const {
    const double t = step_s_;
    return {.s_mm = now_.s_mm + t * (now_.v_mm_s + t * (0.5 * now_.a_mm_s2 + t * jerk_mm_s3 / 6.0)),
            .v_mm_s = now_.v_mm_s + t * (now_.a_mm_s2 + 0.5 * t * jerk_mm_s3),
            .a_mm_s2 = now_.a_mm_s2 + t * jerk_mm_s3};
  }

  // At the ends of the cells that a step passes, where derivatives may jump: on both sides.
  [[nodiscard]] Range jerks_at_ends(const profiles::PathMotion& end, std::size_t last) const {
    Range range;
    const double v_mm_s = std::max(now_.v_mm_s, end.v_mm_s);
    for (std::size_t i = cell_; i < last; ++i) {
      const double share = (way_->way_to_end_mm(i) - now_.s_mm) / (end.s_mm - now_.s_mm);
      const double time_s = std::clamp(share, 0.0, 1.0) * step_s_;
      const Cell& before = way_->cells()[i];
      const Cell& behind = way_->cells()[i + 1];
      range.narrow(jerks({&before, path_(before, before.s_end_mm()), i}, v_mm_s, time_s));
      range.narrow(jerks({&behind, path_(behind, behind.s_begin_mm), i + 1}, v_mm_s, time_s));
    }
    return range;
  }

  // False: the limits leave no jerk, or the way leaves what is known.
  bool go_on(const Place& place) {
    const Range here = jerks(place, now_.v_mm_s, 0.0);
    double jerk_mm_s3 = here.low;
    for (int round = 0; round < kRounds; ++round) {
      const profiles::PathMotion end = end_of_step(jerk_mm_s3);
      const auto there = at(end.s_mm);
      if (!there || !(end.v_mm_s > 0.0)) {
        return false;
      }
      Range range = here;
      range.narrow(jerks(*there, end.v_mm_s, step_s_));
      range.narrow(jerks_at_ends(end, there->index));
      const Range a = accelerations(*there, end);
      range.narrow(
          {.low = (a.low - now_.a_mm_s2) / step_s_, .high = (a.high - now_.a_mm_s2) / step_s_});
      if (!(range.low <= range.high)) {
        return false;
      }
      jerk_mm_s3 = range.low;
    }
    laws_.push_back(profiles::CellLaw::ramp(
        {.v_mm_s = now_.v_mm_s, .a_mm_s2 = now_.a_mm_s2, .j_mm_s3 = jerk_mm_s3}, step_s_));
    now_ = end_of_step(jerk_mm_s3);
    if (const auto now = way_->place_at({.way_mm = now_.s_mm, .from = cell_})) {
      cell_ = now->cell;
    }
    return true;
  }

  const WayAhead* way_;
  PathAt path_;
  const PlanLimits* limits_;
  double landing_;
  profiles::PathMotion now_;  // s counts from the begin
  double step_s_ = 0.0;
  std::size_t cell_ = 0;
  std::vector<profiles::CellLaw> laws_;
};

}  // namespace

std::vector<std::vector<profiles::CellLaw>> steepest_braking(const StartState& begin,
                                                             const WayAhead& way,
                                                             const PlanLimits& limits) {
  std::vector<std::vector<profiles::CellLaw>> ways;
  for (const double landing : kLandings) {
    if (auto laws = Steps(begin, way, limits, landing).to_rest()) {
      ways.push_back(*std::move(laws));
    }
  }
  return ways;
}

}  // namespace kerf::lookahead
