#include "programs/kerf/page/plan_gatherer.hpp"

#include <algorithm>
#include <utility>

namespace kerf::program {

namespace {

double tolerance_of(const curves::Extents& extents) {
  double size_mm = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    size_mm = std::max(size_mm, extents.max_mm[k] - extents.min_mm[k]);
  }
  constexpr double kFinest_mm = 1e-6;
  return std::max(PlanGatherer::kPathShare * size_mm, kFinest_mm);
}

}  // namespace

PlanGatherer::PlanGatherer(const TickColumns::Settings& columns, const curves::Extents& extents)
    : columns_(columns), path_({.tolerance_mm = tolerance_of(extents)}) {}

void PlanGatherer::add_notes(Kernel& kernel) {
  codes_.add(last_tick_, kernel.active_codes());
  words_.add(last_tick_, kernel.active_words());
  for (ProgramMessage& message : kernel.take_messages()) {
    if (messages_.size() < kMaxMessages) {
      messages_.push_back(std::move(message));
    }
  }
}

}  // namespace kerf::program
