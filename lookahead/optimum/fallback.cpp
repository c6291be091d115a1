#include "lookahead/optimum/fallback.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <span>
#include <variant>
#include <vector>

namespace kerf::lookahead {

namespace {

constexpr std::size_t kMinBlocks = 2;
// The other profiles are hardly ever faster than all of these.
constexpr std::array kProfilesOnCurves{profiles::ProfileKind::s_curve, profiles::ProfileKind::sine,
                                       profiles::ProfileKind::sigmoid};
// Where the S-curve takes so many times as long as the search's plan, the others are hardly faster
// than that plan, and asking them is dear.
constexpr double kFarBehind = 1.08;
constexpr double kSharp_per_mm = 1e3;  // curvature
// What is less of a lead may be lost again after the blocks that are looked at.
constexpr double kLead = 1.0 - 1e-3;

bool axes_are_unbounded(const PlanLimits& limits) {
  return std::ranges::all_of(limits.axes, [](const MotionLimits& axis) {
    return axis.acceleration_mm_s2 == kUnbounded && axis.jerk_mm_s3 == kUnbounded;
  });
}

// Curves under limits of axes cost more than a search.
bool is_cheap_to_plan(const Block& block, const PlanLimits& limits) {
  return !std::holds_alternative<curves::NurbsCurve>(block.curve) || axes_are_unbounded(limits);
}

// From the first given on. Elsewhere the S-curve's constants are less than what the axes allow at
// most places.
bool have_constant_limits(const FirstBlocks& run, std::size_t first, const PlanLimits& limits) {
  if (axes_are_unbounded(limits)) {
    return true;
  }
  for (std::size_t i = first; i < run.count; ++i) {
    if (!std::holds_alternative<curves::Line>((*run.blocks)[i].curve)) {
      return false;
    }
  }
  return true;
}

// A rest within a block, a jump of direction or curvature, or a turn within a micrometre.
bool has_singular_place(const PlannedCells& planned) {
  for (std::size_t i = 0; i < planned.count; ++i) {
    const Cell& cell = (*planned.cells)[i];
    if ((cell.rest_after && !cell.ends_block) || cell.allowed.jerk < 1.0 ||
        curves::vec(cell.end.second_per_mm).norm() > kSharp_per_mm) {
      return true;
    }
  }
  return false;
}

std::vector<BlockPassing> classical_passings(const FirstBlocks& first,
                                             const ClassicalSchedule::Settings& settings,
                                             profiles::ProfileKind profile) {
  ClassicalSchedule::Settings trial = settings;
  trial.profile = profiles::Profile(profile);
  trial.observer = nullptr;  // nothing of it is run
  trial.longest_cruise_s = kUnbounded;
  ClassicalSchedule schedule(trial);
  return passings_from_rest(schedule, first, settings.limits);
}

// The classical schedule comes to rest where the search's plan goes on. It leads where at the last
// place that it passes no more slowly, in the second half, it is there earlier.
struct Passings {
  const std::vector<BlockPassing>& classical;
  const std::vector<BlockPassing>& searched;
};
bool classical_leads(const Passings& passings) {
  const auto& [classical, searched] = passings;
  for (std::size_t i = classical.size(); 2 * i > classical.size(); --i) {
    const BlockPassing& passing = classical[i - 1];
    if (passing.v_mm_s >= searched[i - 1].v_mm_s) {
      return passing.t_s < kLead * searched[i - 1].t_s;
    }
  }
  return false;
}

struct Asked {
  std::span<const profiles::ProfileKind> profiles;
  bool to_lead = false;  // is enough: the run goes on as it is
};

// None: none is faster than the search's plan.
std::optional<profiles::ProfileKind> fastest_profile(const FirstBlocks& first,
                                                     const ClassicalSchedule::Settings& settings,
                                                     const std::vector<BlockPassing>& searched,
                                                     const Asked& asked) {
  std::optional<profiles::ProfileKind> fastest;
  double least_s = searched.back().t_s;
  for (const profiles::ProfileKind profile : asked.profiles) {
    const std::vector<BlockPassing> passings = classical_passings(first, settings, profile);
    const double duration_s = passings.back().t_s;
    if (duration_s < least_s || (asked.to_lead && classical_leads({passings, searched}))) {
      least_s = duration_s;
      fastest = profile;
    }
    if (duration_s > kFarBehind * searched.back().t_s) {
      break;
    }
  }
  return fastest;
}

}  // namespace

std::vector<BlockPassing> passings_from_rest(Schedule& schedule, const FirstBlocks& first,
                                             const PlanLimits& limits) {
  Window<Block> copies;
  for (std::size_t i = 0; i < first.count; ++i) {
    copies.push_back(Block((*first.blocks)[i]));
    schedule.push(copies);
  }
  std::vector<BlockPassing> passings;
  Emitter emitter(limits.period_s);
  Outbox outbox;
  PlanClock clock(limits.period_s);
  double v_mm_s = 0.0;
  bool rests = false;
  while (!schedule.empty()) {
    schedule.emit(copies, Supply::to_rest, emitter, outbox);
    for (const interp::Phase& phase : outbox.phases) {
      if (rests) {
        clock.align_to_tick();
      }
      clock.advance(phase.law.duration_s());
      rests = phase.ends_at_rest;
      v_mm_s = rests ? 0.0 : phase.law.at(phase.law.duration_s()).v_mm_s;
    }
    outbox.clear();
    passings.resize(first.count - copies.size(), {.t_s = clock.now_s(), .v_mm_s = v_mm_s});
  }
  return passings;
}

std::optional<Fallback> faster_fallback(const PlannedCells& planned, const FirstBlocks& run,
                                        const ClassicalSchedule::Settings& settings) {
  const Window<Block>& blocks = *run.blocks;
  Fallback whole;
  bool is_cheap = true;
  for (std::size_t i = 0; i < planned.count; ++i) {
    const Cell& cell = (*planned.cells)[i];
    if (cell.ends_block) {
      is_cheap &= is_cheap_to_plan(blocks[whole.blocks], settings.limits);
      ++whole.blocks;
      whole.cells = i + 1;
    }
  }
  const bool has_curves = !is_cheap;
  is_cheap |= planned.tried || (planned.count <= kFewCells && has_singular_place(planned));
  const bool is_asked = planned.failed
                            ? whole.blocks >= kMinBlocks
                            : whole.blocks > 0 && is_cheap &&
                                  have_constant_limits(run, whole.blocks, settings.limits);
  if (!is_asked) {
    return std::nullopt;
  }
  assert(planned.passings.size() == whole.blocks);
  const std::span profiles(kProfilesOnCurves);
  const bool ends_at_rest = (*planned.cells)[whole.cells - 1].rest_after;
  const auto profile = fastest_profile(
      {.blocks = &blocks, .count = whole.blocks}, settings, planned.passings,
      {.profiles = has_curves && ends_at_rest ? profiles : profiles.first(1),
       .to_lead = !planned.failed && have_constant_limits(run, 0, settings.limits)});
  if (!profile) {
    return std::nullopt;
  }
  whole.profile = *profile;
  return whole;
}

}  // namespace kerf::lookahead
