#include "programs/kerf/page/plan_gatherer.hpp"

#include <utility>

namespace kerf::program {

PlanGatherer::PlanGatherer(const TickColumns::Settings& columns, const curves::Extents& extents)
    : columns_(columns), path_({.tolerance_mm = drawn_tolerance_mm(extents)}) {}

void PlanGatherer::add_notes(Kernel& kernel) {
  codes_.add(last_tick_, kernel.active_codes());
  words_.add(last_tick_, kernel.active_words());
  for (ProgramMessage& message : kernel.take_messages()) {
    if (messages_.size() < kMaxMessages) {
      messages_.push_back(std::move(message));
    }
  }
  if (watch_ && last_tick_ % kTicksOfWatch == 0) {
    watch_(*this, kernel);
  }
}

}  // namespace kerf::program
