// A program's ticks from the first to the last, without a clock; with one: real_time_loop.hpp.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <kerf/kernel.hpp>

#include "kernel/tick_judge.hpp"
#include "programs/kerf/report/time_histogram.hpp"
#include "programs/kerf/run/feeder.hpp"
#include "programs/kerf/run/recorder.hpp"
#include "programs/kerf/run/tick_stage.hpp"

namespace kerf::program {

struct RunStage {
  Feeder& feeder;
  TickStage& ticks;
  Recorder& recorder;
  Progress& progress;
  bool waits_for_text = false;  // a tick without motion is no defect: the text is still to come
  std::int64_t last_tick = std::numeric_limits<std::int64_t>::max();  // of a run without a clock
};

// A time without ticks after this tick.
struct TickGap {
  double duration_s = 0.0;
  std::uint32_t line = 0;
  std::int64_t tick = 0;
};

struct RunOutcome {
  std::optional<RunFigures> figures;       // where the kernel may have made more ticks than ran
  bool hung = false;                       // a defect: all is planned, and still the tick waits
  std::uint64_t starved_ticks = 0;         // rested because nothing was planned yet
  std::uint64_t late_ticks = 0;            // began a period or more after their time
  TimeHistogram delays;                    // of each tick behind its time
  TimeHistogram tick_times;                // how long each took
  std::vector<std::string> not_permitted;  // of what RealTimeThread does
  std::uint64_t dropped_records = 0;
  bool has_enough = false;     // Recorder::has_enough(): a run without a clock ends then
  std::optional<TickGap> gap;  // a fault
  // The first tick that was later than the order lets pass: a fault, and the program was stopped.
  std::optional<TickGap> too_late;
  // A run without a clock was not over by its last tick; the line of the program at that.
  std::optional<std::uint32_t> too_long_at_line;
};

// One tick after the other, as fast as it goes. A request to stop (interrupt.hpp) is a stop on the
// path, after which the run is over; a fault of the machine ends it at once, and so does a trace
// that ends: the motion serves nobody.
RunOutcome run_in_one_thread(Kernel& kernel, const RunStage& stage);
// The same: planning and ticks have threads of their own, ahead of the machine, which has this one.
// Not for the page's notes, nor for text that is still to come. judge: for this run alone; of ticks
// that were made ahead and not run it sees nothing.
RunOutcome run_in_threads(Kernel& kernel, const RunStage& stage, TickJudge& judge);

}  // namespace kerf::program
