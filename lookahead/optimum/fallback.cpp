#include "lookahead/optimum/fallback.hpp"

#include <algorithm>
#include <variant>

namespace kerf::lookahead {

namespace {

constexpr std::size_t kMinBlocks = 2;

constexpr std::size_t kFewCells = 3000;

// Curves under limits of axes cost more than a search.
bool is_cheap_to_plan(const Block& block, const PlanLimits& limits) {
  return !std::holds_alternative<curves::NurbsCurve>(block.curve) ||
         std::ranges::all_of(limits.axes, [](const MotionLimits& axis) {
           return axis.acceleration_mm_s2 == kUnbounded && axis.jerk_mm_s3 == kUnbounded;
         });
}

// A rest within a block, or a jump of direction or curvature.
bool has_singular_place(const PlannedCells& planned) {
  for (std::size_t i = 0; i < planned.count; ++i) {
    const Cell& cell = (*planned.cells)[i];
    if ((cell.rest_after && !cell.ends_block) || cell.allowed.jerk < 1.0) {
      return true;
    }
  }
  return false;
}

// How long the schedule takes from rest over the first blocks to rest at the end of the last.
double classical_s(const Window<Block>& blocks, std::size_t count,
                   const ClassicalSchedule::Settings& settings) {
  ClassicalSchedule::Settings trial = settings;
  trial.observer = nullptr;  // nothing of it is run
  ClassicalSchedule schedule(trial);
  Window<Block> copies;
  for (std::size_t i = 0; i < count; ++i) {
    copies.push_back(Block(blocks[i]));
    schedule.push(copies);
  }
  Emitter emitter(settings.limits.period_s);
  Outbox outbox;
  double sum_s = 0.0;
  while (!schedule.empty()) {
    schedule.emit(copies, Supply::to_rest, emitter, outbox);
    for (const interp::Phase& phase : outbox.phases) {
      sum_s += phase.law.duration_s();
    }
    outbox = {};
  }
  return sum_s;
}

}  // namespace

std::optional<Fallback> faster_fallback(const PlannedCells& planned, const Window<Block>& blocks,
                                        const ClassicalSchedule::Settings& settings) {
  Fallback whole;
  double whole_mm = 0.0;
  double all_mm = 0.0;
  bool is_cheap = true;
  for (std::size_t i = 0; i < planned.count; ++i) {
    const Cell& cell = (*planned.cells)[i];
    all_mm += cell.length_mm;
    if (cell.ends_block) {
      is_cheap &= is_cheap_to_plan(blocks[whole.blocks], settings.limits);
      ++whole.blocks;
      whole.cells = i + 1;
      whole_mm = all_mm;
    }
  }
  is_cheap |= planned.count <= kFewCells && has_singular_place(planned);
  if (!(planned.failed ? whole.blocks >= kMinBlocks : whole.blocks > 0 && is_cheap) ||
      !(classical_s(blocks, whole.blocks, settings) * all_mm < planned.duration_s * whole_mm)) {
    return std::nullopt;
  }
  return whole;
}

}  // namespace kerf::lookahead
