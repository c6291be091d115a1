// A program's ticks from the first to the last, with a clock or without.
#pragma once

#include <cstdint>

#include "programs/feeder.hpp"
#include "programs/recorder.hpp"
#include "programs/tick_stage.hpp"

namespace kerf::program {

struct RunStage {
  Feeder& feeder;
  TickStage& ticks;
  Recorder& recorder;
  Progress& progress;
  bool waits_for_text = false;  // a tick without motion is no defect: the text is still to come
};

struct RunOutcome {
  bool hung = false;                // a defect: all is planned, and still the tick waits
  std::uint64_t starved_ticks = 0;  // rested because nothing was planned yet
  std::uint64_t late_ticks = 0;     // began a period or more behind their time
  double worst_delay_s = 0.0;       // of a tick behind its time
  std::uint64_t dropped_records = 0;
};

// One after the other in this thread, as fast as it goes. A request to stop (interrupt.hpp) is a
// stop on the path, after which the run is over; a fault of the machine ends it at once.
RunOutcome run_without_clock(const RunStage& stage);

// The same ticks, one every period_s of CLOCK_MONOTONIC, in this thread; planning and recording
// each have a thread of their own. A late tick is counted, and those after it keep their distance:
// what was lost is not caught up with.
RunOutcome run_in_real_time(const RunStage& stage, double period_s);

}  // namespace kerf::program
