#include "lookahead/optimum/stop_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lookahead/optimum/solver/limit_check.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kLooksATick = 2.0;
constexpr double kRounded = 1.0 + 1e-9;

int looks_at(const profiles::CellLaw& law, double period_s) {
  constexpr double kMax = 1e6;
  return static_cast<int>(std::min(std::ceil(kLooksATick * law.duration_s() / period_s), kMax));
}

class StopCheck {
 public:
  StopCheck(const WayAhead& way, const PlanLimits& limits)
      : way_(&way), path_(way.path()), limits_(&limits) {}

  // s counts from the motion. The ends of cells that were passed since the place before have bounds
  // of their own, for the higher of the two feedrates.
  bool keeps_limits(profiles::PathMotion motion) {
    const std::vector<Cell>& cells = way_->cells();
    const auto here = way_->place_at({.way_mm = motion.s_mm, .from = cell_});
    if (!here) {
      return false;
    }
    profiles::PathMotion passing = motion;
    passing.v_mm_s = std::max(v_mm_s_, motion.v_mm_s);
    for (; cell_ < here->cell; ++cell_) {
      if (!is_within(passing, cells[cell_], cells[cell_].length_mm) ||
          !is_within(passing, cells[cell_ + 1], 0.0)) {
        return false;
      }
    }
    v_mm_s_ = motion.v_mm_s;
    return is_within(motion, cells[cell_], here->s_mm - cells[cell_].s_begin_mm);
  }

 private:
  [[nodiscard]] bool is_within(profiles::PathMotion motion, const Cell& cell, double s_mm) const {
    motion.s_mm = s_mm;
    return excess_at(motion, cell, path_, *limits_).largest() <= kRounded;
  }

  const WayAhead* way_;
  PathAt path_;
  const PlanLimits* limits_;
  // The place before.
  std::size_t cell_ = 0;
  double v_mm_s_ = 0.0;
};

}  // namespace

bool keeps_limits(std::span<const BrakingLaw> laws, const WayAhead& way, const PlanLimits& limits) {
  StopCheck check(way, limits);
  double way_mm = 0.0;
  for (const auto& [law, is_steady] : laws) {
    const int looks = law.duration_s() > 0.0 ? looks_at(law, limits.period_s) : -1;
    for (int look = 0; look <= looks; ++look) {
      profiles::PathMotion motion = law.at(law.duration_s() * look / looks);
      motion.s_mm += way_mm;
      if (!check.keeps_limits(motion)) {
        return false;
      }
    }
    way_mm += law.length_mm();
  }
  return true;
}

}  // namespace kerf::lookahead
