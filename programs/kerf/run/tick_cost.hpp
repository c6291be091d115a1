// What a tick costs on this computer, and which period it bears.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/report/time_histogram.hpp"

namespace kerf::program {

struct TickCostOrder {
  double measured_s = 5.0;
  bool realtime = false;
};

struct TickCost {
  double period_s = 0.001;                   // at which it was measured
  TimeHistogram tick_times{};                // how long each tick took
  TimeHistogram delays{};                    // how late each began
  std::vector<std::string> not_permitted{};  // RealTimeThread

  // The shortest of 10, 20, 50 us ... 0.1 s into which the worst delay and the worst tick fit one
  // after the other; nothing: none.
  [[nodiscard]] std::optional<double> shortest_period_s() const noexcept;
};

// Runs a program of lines, arcs, helices and a NURBS curve in real time on the simulated table,
// with planning beside it, over and over until the time is up or somebody asks to stop. Error: the
// machine cannot run it.
tl::expected<TickCost, std::string> measure_tick_cost(const TickCostOrder& order,
                                                      MachineSettings settings);

[[nodiscard]] std::string tick_cost_text(const TickCost& cost);
[[nodiscard]] std::string tick_cost_json(const TickCost& cost);

}  // namespace kerf::program
