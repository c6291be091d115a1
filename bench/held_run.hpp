// A program that is held at one of its ticks.
#pragma once

#include <cstdint>
#include <vector>

#include <kerf/kernel.hpp>

#include "bench/control_programs.hpp"
#include "bench/shortest_stop.hpp"
#include "tests/kernel/planned_path.hpp"

namespace kerf::bench {

struct Held {
  double reaction_ms = 0.0;  // of ticks, from the request to the first that is another
  // Of these the last, at which the plan itself brakes as hard as the path's limits allow: whatever
  // takes over there gives the same ticks.
  double at_limit_ms = 0.0;
  bool rests_as_planned = true;  // none is: the plan braked to a rest that is as near
  double planning_ms = 0.0;
  double rest_ms = 0.0;
  double begin_mm = 0.0;  // of the last tick that was not another
  // From the first that is, which is the first whose motion is known to brake: between these two
  // the plan before may go on for a part of a tick, with another acceleration.
  WayToRest way{};

  [[nodiscard]] double could_show_ms() const { return reaction_ms - at_limit_ms; }
  [[nodiscard]] double way_mm() const { return way.from.s_mm + way.way_mm - begin_mm; }
};

class HeldRun {
 public:
  // Runs it without a hold. The program is to outlive it.
  HeldRun(const ControlProgram& program, ProfileKind profile);

  [[nodiscard]] std::int64_t ticks() const { return static_cast<std::int64_t>(whole_.size()); }
  [[nodiscard]] Kernel fresh(bool one_thread = true) const;
  [[nodiscard]] test::PlannedPath path() const;
  // Watches ticks from the request on. True: the tool rests.
  [[nodiscard]] bool watch(TickStatus status, const Setpoint& setpoint, Held& held) const;
  // In virtual time.
  [[nodiscard]] Held hold_at(std::int64_t tick) const;
  // At which it is held: the same of all runs of that many ticks.
  [[nodiscard]] std::vector<std::int64_t> random_ticks() const;

 private:
  [[nodiscard]] bool brakes_at_limit(std::int64_t tick) const;

  const ControlProgram* program_;
  KernelOptions options_;
  std::vector<Setpoint> whole_;  // its first ticks, without a hold
};

// How many ticks HeldRun::random_ticks() are.
inline constexpr int kHolds = 60;

// The value that this share of all is not above.
double quantile(std::vector<double> values, double share);

}  // namespace kerf::bench
