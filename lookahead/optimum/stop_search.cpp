#include "lookahead/optimum/stop_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "interp/motion.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"
#include "lookahead/optimum/steepest_braking.hpp"
#include "lookahead/optimum/stop_cells.hpp"
#include "lookahead/optimum/stop_check.hpp"
#include "profiles/s_curve_stop.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kStep = 1.03;
// Over the way of the S-curve, where that or the steps have one: the optimum may be as short.
constexpr double kNearest = 1.01;
// Over the way of the S-curve, until one is far enough; the last where those before are not known.
constexpr std::array<double, 5> kDistances{2.2, 3.1, 4.6, 1.5, 1.05};
constexpr std::array<double, kStopDistances.size()> kDistancesOfAny{1.7, 3.1, 5.6};
constexpr std::size_t kMinCells = 3;
// More come of a way that is no way: near a rest, at a crawl.
constexpr std::size_t kMaxCells = 256;
// Of the limits that hold where the motion is, for an S-curve on a curve.
constexpr std::array<double, 3> kShares{1.0, 0.7, 0.5};
// A try that takes more does not end well in most cases; there are others.
constexpr int kRefinements = 12;
constexpr int kPointsOfPart = 20;  // of the S-curve

double way_mm(const std::vector<BrakingPart>& parts) {
  double sum_mm = 0.0;
  for (const BrakingPart& part : parts) {
    sum_mm += part.law.at(part.law.duration_s()).s_mm;
  }
  return sum_mm;
}

std::optional<std::vector<BrakingPart>> shorter(std::optional<std::vector<BrakingPart>> one,
                                                std::optional<std::vector<BrakingPart>> other) {
  const bool is_one = one && !(other && way_mm(*other) < way_mm(*one));
  return is_one ? std::move(one) : std::move(other);
}

}  // namespace

StopSearch::StopSearch(const BrakingFrom& from, const PlanLimits& limits)
    : from_(&from), limits_(&limits), way_(from, limits) {
  if (!way_.cells().empty()) {
    take_s_curve();
  }
}

// With a share of the limits that hold where the motion is.
std::optional<profiles::SCurveStop> StopSearch::s_curve(double share) const {
  const Cell& first = way_.cells().front();
  const StartState& begin = from_->state;
  const double acceleration =
      tangential_acceleration_mm_s2(first, first.begin, *limits_) / first.shares.acceleration;
  const double jerk = tangential_jerk_mm_s3(first, first.begin, *limits_) / first.shares.jerk;
  return profiles::s_curve_stop(
      {.v_mm_s = begin.v_mm_s, .a_mm_s2 = begin.a_mm_s2},
      {std::max(share * acceleration, std::abs(begin.a_mm_s2)), share * jerk});
}

// The closed form; where there is none, steady braking.
void StopSearch::take_s_curve() {
  const auto stop = s_curve(kAim);
  const double v = from_->state.v_mm_s;
  double way_mm = 0.0;
  s_curve_ = {{.s_mm = 0.0, .v_squared = v * v}};
  if (!stop) {
    const Cell& first = way_.cells().front();
    s_curve_.push_back(
        {.s_mm = 0.5 * v * v / tangential_acceleration_mm_s2(first, first.begin, *limits_)});
    return;
  }
  for (const profiles::CellLaw* law : {&stop->falling, &stop->steady, &stop->landing}) {
    for (int i = 1; i <= kPointsOfPart && law->duration_s() > 0.0; ++i) {
      const profiles::PathMotion motion = law->at(law->duration_s() * i / kPointsOfPart);
      s_curve_.push_back(
          {.s_mm = way_mm + motion.s_mm, .v_squared = motion.v_mm_s * motion.v_mm_s});
    }
    way_mm += law->length_mm();
  }
}

// Drawn out to the distance it decelerates less, so it is near what can be done.
void StopSearch::begin_with_s_curve(double distance_mm, std::vector<Cell>& cells) const {
  double way_mm = 0.0;
  auto after = s_curve_.begin() + 1;
  for (Cell& cell : cells) {
    const double s_mm =
        (way_mm + 0.5 * cell.length_mm) * s_curve_.back().s_mm / std::max(distance_mm, way_mm);
    while (after + 1 != s_curve_.end() && after->s_mm < s_mm) {
      ++after;
    }
    const SCurvePoint& before = *(after - 1);
    const double share = std::clamp((s_mm - before.s_mm) / (after->s_mm - before.s_mm), 0.0, 1.0);
    cell.planned_squared = before.v_squared + share * (after->v_squared - before.v_squared);
    way_mm += cell.length_mm;
  }
}

bool StopSearch::reaches_end(double distance_mm) const {
  return way_.knows(distance_mm) && cells_to(distance_mm, way_.cells(), way_.path()).is_end;
}

bool StopSearch::is_in_reach(double distance_mm) const {
  const auto rest = way_.place_at({.way_mm = distance_mm});
  return way_.knows(distance_mm) && !(rest && rest->cell >= kMaxCells);
}

StopSearch::RestTry StopSearch::to_rest_at(double distance_mm, StopGrid grid) const {
  if (!is_in_reach(distance_mm)) {
    return {};
  }
  const PathAt path = way_.path();
  CellsToRest to_rest = cells_to(distance_mm, way_.cells(), path);
  RestTry tried{.is_end = to_rest.is_end};
  if (to_rest.cells.empty()) {
    return tried;
  }
  CellSequence sequence{.begin = from_->state, .cells = std::move(to_rest.cells)};
  divide_for_rest({.distance_mm = distance_mm, .grid = grid}, path, *limits_, sequence.cells);
  if (sequence.cells.size() >= kMinCells && sequence.cells.size() <= kMaxCells) {
    begin_with_s_curve(distance_mm, sequence.cells);
    tried.plan = OptimalPlan::find(std::move(sequence), path, *limits_, kRefinements);
  }
  return tried;
}

std::optional<std::vector<BrakingPart>> StopSearch::any(StopDistance distance) const {
  if (distance == StopDistance::near) {
    if (auto s_curve = in_closed_form()) {
      return s_curve;
    }
  }
  std::optional<OptimalPlan> found;
  if (!way_.cells().empty() && s_curve_.back().s_mm >= kAtBlockEnd_mm) {
    const auto i = static_cast<std::size_t>(distance);
    const double s_curve_mm = s_curve_.back().s_mm;
    if (i == 0 || !reaches_end(kDistancesOfAny[i - 1] * s_curve_mm)) {
      found = to_rest_at(kDistancesOfAny[i] * s_curve_mm, StopGrid::coarse).plan;
    }
  }
  if (found) {
    return parts(*found);
  }
  return distance == StopDistance::farthest ? steepest() : std::nullopt;
}

// Once there is a way, what is between it and the longest distance without one is divided down to
// kStep. The S-curve is taken to be such a one. Where the path bends within a cell there may be a
// way that few cells cannot show: what they found too short is tried once more with more of them.
std::optional<std::vector<BrakingPart>> StopSearch::shortest(const IsLate& is_late_now) const {
  bool has_been_late = false;
  const IsLate is_late = [&] { return has_been_late = has_been_late || is_late_now(); };
  if (way_.cells().empty() || s_curve_.back().s_mm < kAtBlockEnd_mm) {
    return in_closed_form();
  }
  const double s_curve_mm = s_curve_.back().s_mm;
  Tried tried{.best = shorter(s_curve_parts(1.0), steepest()), .too_short_mm = s_curve_mm};
  tried.best_mm = tried.best ? way_mm(*tried.best) : kUnbounded;
  if (tried.best && tried.best_mm > kNearest * s_curve_mm && !is_late()) {
    try_at(kNearest * s_curve_mm, tried);
  }
  for (std::size_t i = 0; i < kDistances.size() && !tried.best && !tried.is_end; ++i) {
    const double next_mm = kDistances[i] * s_curve_mm;
    if (next_mm > tried.too_short_mm && is_in_reach(next_mm)) {
      try_at(next_mm, tried);
    }
  }
  divide_down(is_late, tried);
  const double missed_mm = std::exchange(tried.too_short_mm, s_curve_mm);
  if (tried.best && missed_mm > s_curve_mm && !is_late()) {
    tried.grid = StopGrid::fine;
    try_at(missed_mm, tried);
    divide_down(is_late, tried);
  }
  return tried.best ? std::move(tried.best) : in_closed_form();
}

void StopSearch::divide_down(const IsLate& is_late, Tried& tried) const {
  while (tried.best && tried.best_mm > kStep * tried.too_short_mm && !is_late()) {
    try_at(std::sqrt(tried.too_short_mm * tried.best_mm), tried);
  }
}

void StopSearch::try_at(double distance_mm, Tried& tried) const {
  const RestTry found = to_rest_at(distance_mm, tried.grid);
  tried.is_end = found.is_end;
  if (found.plan) {
    tried.best = parts(*found.plan);
    tried.best_mm = std::min(way_mm(*tried.best), distance_mm);
  } else {
    tried.too_short_mm = distance_mm;
  }
}

std::optional<std::vector<BrakingPart>> StopSearch::in_closed_form() const {
  for (std::size_t i = 0; i < kShares.size() && !way_.cells().empty(); ++i) {
    if (auto parts = s_curve_parts(kShares[i])) {
      return parts;
    }
  }
  return std::nullopt;
}

std::optional<std::vector<BrakingPart>> StopSearch::s_curve_parts(double share) const {
  const auto stop = s_curve(share);
  return stop ? parts_along(laws_of(*stop)) : std::nullopt;
}

std::optional<std::vector<BrakingPart>> StopSearch::steepest() const {
  if (way_.cells().empty()) {
    return std::nullopt;
  }
  for (const std::vector<profiles::CellLaw>& steps :
       steepest_braking(from_->state, way_, *limits_)) {
    std::vector<BrakingLaw> laws;
    laws.reserve(steps.size());
    for (const profiles::CellLaw& law : steps) {
      laws.push_back({.law = law});
    }
    if (auto parts = parts_along(laws)) {
      return parts;
    }
  }
  return std::nullopt;
}

std::optional<std::vector<BrakingPart>> StopSearch::parts_along(
    std::span<const BrakingLaw> laws) const {
  if (!keeps_limits(laws, way_, *limits_)) {
    return std::nullopt;
  }
  auto parts = parts_of(laws, *from_);
  return parts && parts->size() <= interp::StopAhead::kPhases ? std::move(parts) : std::nullopt;
}

std::vector<BrakingPart> StopSearch::parts(const OptimalPlan& plan) const {
  std::vector<BrakingPart> parts;
  for (std::size_t i = 0; i < plan.cells().size(); ++i) {
    const Cell& cell = plan.cells()[i];
    const std::size_t block = way_.block_of(cell);
    const double begin_mm = way_.begin_mm(block);
    parts.push_back(
        {.block = block,
         .law = plan.law_from({.cell = i}, kUnbounded),
         .s_end_mm = cell.ends_block ? from_->blocks[block]->length_mm : begin_mm + cell.s_end_mm(),
         .ends_block = cell.ends_block,
         .limit = plan.limit_on(i, *limits_)});
  }
  return parts;
}

}  // namespace kerf::lookahead
