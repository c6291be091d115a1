// Planned motion as a function of time, put together again from what the planner emits.
#pragma once

#include <vector>

#include "lookahead/planner.hpp"

namespace kerf::lookahead::test {

class Motion {
 public:
  Motion(std::vector<interp::Phase> phases, double period_s);

  [[nodiscard]] const std::vector<interp::Phase>& phases() const { return phases_; }
  // Of the whole program: end of the last phase.
  [[nodiscard]] double duration_s() const;
  [[nodiscard]] double begin_s(const interp::Phase& phase) const;
  // Path length since the program's start and its derivatives, at t_s in [0, duration].
  [[nodiscard]] profiles::PathMotion at(double t_s) const;

 private:
  std::vector<interp::Phase> phases_;
  double period_s_;
};

// Pushes the blocks, finishes, and takes all that comes out.
Outbox run(Planner& planner, const std::vector<Block>& blocks);
Motion plan(const std::vector<Block>& blocks, const PlannerSettings& settings);

}  // namespace kerf::lookahead::test
