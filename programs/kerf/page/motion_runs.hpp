// Which line is run when, and what the machine does in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "programs/kerf/report/tick_record.hpp"

namespace kerf::program {

// From its tick up to that of the next run.
struct LineRun {
  std::int64_t tick = 0;
  std::uint32_t line = 0;
  std::int32_t tool = 0;  // in the spindle
  TickKind kind = TickKind::rest;
};

// A run ends where line, kind or tool change. When runs run out, short ones in a row become one
// that has the line of its first; until then the time of each line is exact.
class MotionRuns {
 public:
  static constexpr std::size_t kMaxRuns = 4'000'000;

  // max_runs >= 8
  explicit MotionRuns(std::size_t max_runs = kMaxRuns) : max_runs_(max_runs) {}

  // Ticks come in ascending order.
  void add(const TickRecord& record);

  [[nodiscard]] const std::vector<LineRun>& runs() const noexcept { return runs_; }
  // Runs shorter than that may have been joined; 1: none.
  [[nodiscard]] std::int64_t shortest_ticks() const noexcept { return shortest_ticks_; }

 private:
  void join_short();

  std::size_t max_runs_;
  std::int64_t shortest_ticks_ = 1;
  std::vector<LineRun> runs_;
};

}  // namespace kerf::program
