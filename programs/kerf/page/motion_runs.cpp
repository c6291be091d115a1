#include "programs/kerf/page/motion_runs.hpp"

namespace kerf::program {

void MotionRuns::add(const TickRecord& record) {
  const LineRun run{
      .tick = record.tick, .line = record.line, .tool = record.tool, .kind = kind_of(record)};
  if (!runs_.empty() && runs_.back().line == run.line && runs_.back().kind == run.kind &&
      runs_.back().tool == run.tool) {
    return;
  }
  runs_.push_back(run);
  if (runs_.size() >= max_runs_) {
    // The newest are not joined yet.
    join_short();
    while (runs_.size() > max_runs_ / 2) {
      shortest_ticks_ *= 2;
      join_short();
    }
  }
}

void MotionRuns::join_short() {
  std::size_t kept = 1;
  for (std::size_t i = 1; i < runs_.size(); ++i) {
    const bool is_last = i + 1 == runs_.size();
    // A long one has its own begin; of short ones in a row one in that many ticks stands for all.
    if (is_last || runs_[i + 1].tick - runs_[i].tick >= shortest_ticks_ ||
        runs_[i].tick - runs_[kept - 1].tick >= shortest_ticks_) {
      runs_[kept++] = runs_[i];
    }
  }
  runs_.resize(kept);
}

}  // namespace kerf::program
