// Programs that ask the machine, run on the simulated table.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "machine/simulated_table.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {

inline constexpr std::size_t kMaxTableTicks = 400'000;

// A table of lines, exact, 1 ms, with the surface.
inline MachineSettings touching(const TouchSurface& surface, bool latches) {
  MachineSettings settings = default_machine();
  settings.program.path_control = {};
  settings.simulation.surface = surface;
  settings.simulation.latches_probe = latches;
  return settings;
}

struct TableRun {
  std::vector<Setpoint> ticks;
  std::vector<machine::MachineState> states;
  TickStatus status = TickStatus::running;
  std::vector<std::string> messages;  // what the program told the operator
  std::vector<std::string> errors;
  std::string complaint;  // of limits, and of Kerf's own promises
};

inline ProgramInputs inputs_of(const machine::MachineState& state) {
  return {.probe = state.inputs.probe,
          .actual_mm = state.actual_mm,
          .has_latched = state.has_latched,
          .latched_mm = state.latched_mm,
          .digital = state.inputs.digital,
          .analog = state.inputs.analog,
          .spindle_at_speed = state.inputs.spindle_at_speed};
}

inline std::vector<machine::ToolOffset> tools_of(const MachineSettings& settings) {
  std::vector<machine::ToolOffset> tools;
  for (const Tool& tool : settings.program.tools.listed()) {
    tools.push_back({.tool = tool.number, .offset_mm = tool.offset_mm});
  }
  return tools;
}

struct TableOrder {
  KernelOptions options{};
  // Called before each tick: to command, or to change what the machine says.
  std::function<void(Kernel&, const TableRun&, ProgramInputs&)> before{};
  // plan() comes only every so many ticks, as from a thread that is late; 0: next() plans.
  std::int64_t plans_every = 0;
};

inline TableRun run_on_table(const MachineSettings& settings, std::string_view text,
                             const TableOrder& order = {}) {
  KernelOptions options = order.options;
  options.asks_machine = options.tells_operator = true;
  Kernel kernel(settings, options);
  kernel.feed(text);
  kernel.finish();
  machine::SimulatedTable table(settings.table, settings.simulation, tools_of(settings));
  table.enable({.mm = options.start_mm});
  TickChecker checker(settings.limits, true);
  TableRun run;
  kernel.plan();
  while (run.ticks.size() < kMaxTableTicks) {
    ProgramInputs inputs = inputs_of(table.read());
    if (order.before) {
      order.before(kernel, run, inputs);
    }
    kernel.set_program_inputs(inputs);
    Setpoint setpoint;
    if (order.plans_every == 0) {
      run.status = kernel.next(setpoint);
    } else {
      if (static_cast<std::int64_t>(run.ticks.size()) % order.plans_every == 0) {
        kernel.plan();
      }
      run.status = kernel.tick(setpoint);
    }
    table.write(setpoint);
    checker.add({.setpoint = setpoint, .feedrate_mm_s = settings.limits.path.velocity_mm_s});
    run.ticks.push_back(setpoint);
    run.states.push_back(table.read());
    if (run.status == TickStatus::finished || run.status == TickStatus::failed) {
      break;
    }
  }
  kernel.plan();
  for (const ProgramMessage& message : kernel.take_messages()) {
    run.messages.push_back(message.text);
  }
  for (const Diagnostic& found : kernel.diagnostics()) {
    if (found.severity == Severity::error) {
      run.errors.push_back(std::to_string(found.source.line) + ": " + found.message);
    }
  }
  run.complaint = checker.complaint();
  if (kernel.fault()) {
    run.complaint += kernel.fault()->what;
  }
  if (table.read().fault != machine::DriveFault::none) {
    run.complaint += "the table has a fault";
  }
  return run;
}

// A run that is to end well.
inline TableRun whole_run(const MachineSettings& settings, std::string_view text,
                          const TableOrder& order = {}) {
  TableRun run = run_on_table(settings, text, order);
  EXPECT_EQ(run.status, TickStatus::finished) << text;
  EXPECT_EQ(run.complaint, "") << text;
  for (const std::string& error : run.errors) {
    ADD_FAILURE() << error << "\n" << text;
  }
  return run;
}

}  // namespace kerf::test
