#include "lookahead/optimum/braking.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "lookahead/optimum/stop_search.hpp"
#include "profiles/s_curve_stop.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kRounded = 1.0 + 1e-9;
constexpr double kNoWay_mm = 1e-12;
constexpr double kNoTime_s = 1e-12;
constexpr double kHardly = 0.01;  // of a block that is short itself

std::optional<std::vector<BrakingPart>> stop_on_line(const BrakingFrom& from,
                                                     const PlanLimits& limits) {
  const Block& block = *from.blocks.front();
  const double clear_mm = junction_zone_mm(from.state, limits);
  if (!std::holds_alternative<curves::Line>(block.curve) ||
      (from.before != nullptr && from.s_mm < clear_mm)) {
    return std::nullopt;
  }
  // A trapezoid turns its acceleration off at once; no jerk within the limits can.
  const double a = std::max(from.state.a_mm_s2, 0.0);
  if (from.state.v_mm_s + 0.5 * a * a / block.limits.ramp.jerk_mm_s3 >
      kRounded * block.limits.feedrate_mm_s) {
    return std::nullopt;
  }
  const auto stop = profiles::s_curve_stop(
      {.v_mm_s = from.state.v_mm_s, .a_mm_s2 = from.state.a_mm_s2}, block.limits.ramp);
  if (!stop || from.s_mm + stop->length_mm() > block.length_mm - kAtBlockEnd_mm) {
    return std::nullopt;
  }
  return parts_of(laws_of(*stop), from);
}

// Lays laws along the blocks. Whatever ends a block is cut there: a phase is on one curve.
class PartsOnBlocks {
 public:
  explicit PartsOnBlocks(const BrakingFrom& from) : from_(&from), s_mm_(from.s_mm) {}

  // False: the law leaves the blocks. The last microseconds before a rest are hardly a way, and
  // without them its acceleration would jump.
  bool add(const BrakingLaw& law) {
    Begin begin;
    while (law.law.length_mm() - begin.way_mm > kNoWay_mm ||
           law.law.duration_s() - begin.t_s > kNoTime_s) {
      if (on_ == from_->blocks.size()) {
        return false;
      }
      begin = add_on_block(law, begin);
    }
    return true;
  }
  [[nodiscard]] bool rests_hardly_before_block_end() const {
    if (parts_.empty()) {
      return false;
    }
    const double length_mm = from_->blocks[parts_.back().block]->length_mm;
    return length_mm - parts_.back().s_end_mm < std::min(kAtBlockEnd_mm, kHardly * length_mm);
  }
  std::vector<BrakingPart> take() { return std::move(parts_); }

 private:
  // Of what is left of a law.
  struct Begin {
    double t_s = 0.0;
    double way_mm = 0.0;
  };

  Begin add_on_block(const BrakingLaw& whole, const Begin& begin) {
    const profiles::CellLaw& law = whole.law;
    const Block& block = *from_->blocks[on_];
    const double to_block_end_mm = begin.way_mm + block.length_mm - s_mm_;
    const bool ends_block = law.length_mm() >= to_block_end_mm - kNoWay_mm;
    const bool goes_on = law.length_mm() > to_block_end_mm + kNoWay_mm;
    const Begin end{.t_s = goes_on ? law.time_at_s(to_block_end_mm) : law.duration_s(),
                    .way_mm = ends_block ? to_block_end_mm : law.length_mm()};
    s_mm_ += end.way_mm - begin.way_mm;
    const LimitOrigins& limits = block.limits.from;
    parts_.push_back({.block = on_,
                      .law = begin.t_s > 0.0 || goes_on
                                 ? law.part({.begin_s = begin.t_s, .end_s = end.t_s})
                                 : law,
                      .s_end_mm = ends_block ? block.length_mm : s_mm_,
                      .ends_block = ends_block,
                      .limit = whole.is_steady ? limits.acceleration : limits.jerk});
    if (ends_block) {
      ++on_;
      s_mm_ = 0.0;
    }
    return end;
  }

  const BrakingFrom* from_;
  std::size_t on_ = 0;
  double s_mm_;
  std::vector<BrakingPart> parts_;
};

// search: made where it is needed, once for all distances.
std::optional<std::vector<BrakingPart>> any_from(const BrakingFrom& from, const PlanLimits& limits,
                                                 StopDistance distance,
                                                 std::optional<StopSearch>& search) {
  if (from.blocks.empty()) {
    return std::nullopt;
  }
  if (!search) {
    if (auto parts = stop_on_line(from, limits)) {
      return parts;
    }
    search.emplace(from, limits);
  }
  return search->any(distance);
}

}  // namespace

std::optional<std::vector<BrakingPart>> parts_of(std::span<const BrakingLaw> laws,
                                                 const BrakingFrom& from) {
  PartsOnBlocks parts(from);
  for (const BrakingLaw& law : laws) {
    if (!parts.add(law)) {
      return std::nullopt;
    }
  }
  return parts.rests_hardly_before_block_end() ? std::nullopt : std::optional(parts.take());
}

std::array<BrakingLaw, 3> laws_of(const profiles::SCurveStop& stop) {
  return {{{.law = stop.falling}, {.law = stop.steady, .is_steady = true}, {.law = stop.landing}}};
}

std::optional<std::vector<BrakingPart>> find_braking(const BrakingFrom& from,
                                                     const PlanLimits& limits,
                                                     const IsLate& is_late) {
  if (from.blocks.empty()) {
    return std::nullopt;
  }
  auto parts = stop_on_line(from, limits);
  return parts ? std::move(parts) : StopSearch(from, limits).shortest(is_late);
}

std::optional<FoundBraking> find_any_braking(const std::vector<BrakingFrom>& motions,
                                             const PlanLimits& limits) {
  std::vector<std::optional<StopSearch>> searches(motions.size());
  for (const StopDistance distance : kStopDistances) {
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (auto parts = any_from(motions[i], limits, distance, searches[i])) {
        return FoundBraking{.motion = i, .parts = *std::move(parts)};
      }
    }
  }
  return std::nullopt;
}

}  // namespace kerf::lookahead
