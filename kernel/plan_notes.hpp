// Tells how a plan is made, as lines of text.
#pragma once

#include <functional>
#include <string_view>
#include <utility>

#include "lookahead/path/plan_observer.hpp"

namespace kerf {

class PlanNotes final : public lookahead::PlanObserver {
 public:
  using Sink = std::function<void(std::string_view line)>;
  // Precondition: sink is not empty.
  explicit PlanNotes(Sink sink) : sink_(std::move(sink)) {}

  void pushed(const lookahead::Block& block) const override;
  void cut(const lookahead::BlockCuts& cuts) const override;
  void planned(const lookahead::PlannedSegment& segment) const override;
  void searched(const lookahead::PlanSearch& search) const override;
  void took_classical(std::size_t blocks) const override;

 private:
  Sink sink_;
};

}  // namespace kerf
