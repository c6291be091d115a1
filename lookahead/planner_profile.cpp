// A time optimum stands in for the profile of the settings, and gives way to it again.
#include <cmath>
#include <memory>
#include <utility>

#include "lookahead/optimum/braking.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/path/remainder.hpp"
#include "lookahead/planner.hpp"

namespace kerf::lookahead {

namespace {

// Where the profile could not go on it is tried again so much later, twice as late each time.
constexpr double kBetweenReturns_s = 0.1;

// The optimum comes to a feedrate in the end, and goes on with next to no acceleration.
bool is_steady(const interp::Phase& phase, double period_s) {
  constexpr double kOfFeedrate = 1e-6;  // in a tick
  constexpr double kOverPhase = 1e-4;
  const profiles::PathMotion end = phase.law.at(phase.law.duration_s());
  const profiles::Ramp ramp = phase.law.ramp();
  return std::abs(end.a_mm_s2) * period_s <= kOfFeedrate * end.v_mm_s &&
         std::abs(ramp.v_end_mm_s - ramp.v_begin_mm_s) <= kOverPhase * end.v_mm_s;
}

}  // namespace

void Planner::stand_in() {
  stands_in_ = settings_.profile.kind() != profiles::ProfileKind::time_optimal;
  next_return_tick_ = 0;
  between_returns_ = std::llround(kBetweenReturns_s / settings_.limits.period_s);
}

void Planner::return_to_profile(const interp::Phase& phase) {
  const profiles::PathMotion end = phase.law.at(phase.law.duration_s());
  if (!emitter_.is_on_block() || !is_steady(phase, settings_.limits.period_s) ||
      emitter_.now().tick < next_return_tick_ ||
      emitter_.curve_mm() < junction_zone_mm({.v_mm_s = end.v_mm_s}, settings_.limits)) {
    return;
  }
  next_return_tick_ = emitter_.now().tick + between_returns_;
  between_returns_ *= 2;
  for (std::size_t i = 1; i < blocks_.size(); ++i) {
    if (blocks_[i].slows) {
      return;
    }
  }
  const Block& present = blocks_[0];
  auto whole = present.whole ? present.whole : std::make_shared<const Block>(present);
  if (whole->slows) {
    auto with_limits = std::make_shared<Block>(*whole);
    set_limits(by_, settings_.limits, scan_for_, *with_limits);
    whole = std::move(with_limits);
  }
  std::optional<Block> remainder = remainder_of(whole, emitter_.curve_mm());
  if (!remainder) {
    return;
  }
  auto schedule = std::make_unique<ClassicalSchedule>(classical_settings());
  schedule->push(*remainder, nullptr);
  for (std::size_t i = 1; i < blocks_.size(); ++i) {
    schedule->push(blocks_[i], i > 1 ? &blocks_[i - 1] : &*remainder);
  }
  if (schedule->begin(end.v_mm_s)) {
    blocks_[0] = *std::move(remainder);
    emitter_.begin_remainder(0.0);
    schedule_ = std::move(schedule);
    stands_in_ = false;
  }
}

}  // namespace kerf::lookahead
