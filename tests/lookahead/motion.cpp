#include "tests/lookahead/motion.hpp"

#include <algorithm>
#include <utility>

namespace kerf::lookahead::test {

Motion::Motion(std::vector<interp::Phase> phases, double period_s)
    : phases_(std::move(phases)), period_s_(period_s) {}

double Motion::begin_s(const interp::Phase& phase) const {
  return static_cast<double>(phase.begin.tick) * period_s_ + phase.begin.offset_s;
}

double Motion::duration_s() const {
  return phases_.empty() ? 0.0 : begin_s(phases_.back()) + phases_.back().law.duration_s();
}

profiles::PathMotion Motion::at(double t_s) const {
  const auto after =
      std::upper_bound(phases_.begin(), phases_.end(), t_s,
                       [this](double t, const interp::Phase& phase) { return t < begin_s(phase); });
  const interp::Phase& phase = after == phases_.begin() ? phases_.front() : *std::prev(after);
  profiles::PathMotion motion = phase.law.at(t_s - begin_s(phase));
  motion.s_mm += phase.path_begin_mm + phase.s_begin_mm;
  return motion;
}

Outbox run(Planner& planner, const std::vector<Block>& blocks) {
  Outbox outbox;
  for (const Block& block : blocks) {
    while (!planner.wants_block() && planner.emit(outbox)) {
    }
    planner.push(Block(block));
  }
  while (!planner.wants_block() && planner.emit(outbox)) {
  }
  planner.finish(99);
  while (planner.emit(outbox)) {
  }
  return outbox;
}

Motion plan(const std::vector<Block>& blocks, const PlannerSettings& settings) {
  Planner planner(settings);
  return {run(planner, blocks).phases, settings.limits.period_s};
}

}  // namespace kerf::lookahead::test
