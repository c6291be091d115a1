// Turns the measurements of a run into its report.
#pragma once

#include <kerf/kernel.hpp>

#include "programs/kerf/report/report.hpp"
#include "programs/kerf/run/run_loop.hpp"

namespace kerf::program {

// Fills in plan, motion, clock (of a run in real time) and the warnings that follow from them.
void report_motion(FileReport& report, const Kernel& kernel, const RunStatistics& statistics,
                   const RunOutcome& outcome);

// "machine fault: following error of axis x too large, in line 12, at 0:00:01.234"
[[nodiscard]] std::string describe(const MachineFault& fault, double period_s);
[[nodiscard]] FaultReport fault_report(const MachineFault& fault, double period_s);
// Of the computer, not of the machine: "no_tick", "late_tick".
[[nodiscard]] FaultReport fault_report(std::string_view kind, const TickGap& gap, double period_s);
// "emergency stop: its loop is open, in line 12, at 0:00:01.234"
[[nodiscard]] std::string describe(const TickStage::EmergencyLoop& loop, double period_s);
// "machine fault: a tick came 0.052 s late; stopped on the path, from line 12, at 0:00:01.234"
[[nodiscard]] std::string describe_delay(const TickGap& delay, double period_s);
// "machine fault: no tick for 1.502 s, in line 12, at 0:00:01.234"
[[nodiscard]] std::string describe(const TickGap& gap, double period_s);

}  // namespace kerf::program
