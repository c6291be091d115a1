// Where the time of a run goes.
#pragma once

#include <cstdint>

#include "programs/kerf/report/tick_record.hpp"

namespace kerf::program {

// In ticks; together all of the run.
struct TimeSplit {
  std::int64_t cutting = 0;
  std::int64_t rapid = 0;
  std::int64_t rest = 0;  // dwells, spindle starts, waits, exact stops of a tick and more
  std::int64_t tool_change = 0;
  std::int64_t approach = 0;  // of the rapids those before the first cut; 0 without one
};

// Where changes take time, of the machine or until somebody answers, the new tool is there from the
// first tick of it on; so it is in the rest after one that takes none.
enum class ToolChange : std::uint8_t { takes_none, takes_time };

// Rests of one line, one after the other, are a tool change if the spindle has another tool after
// them.
class TimeAccount {
 public:
  explicit TimeAccount(ToolChange tool_change) noexcept : tool_change_(tool_change) {}

  // Ticks come in ascending order. Real time: constant work.
  void add(const TickRecord& record) noexcept;
  // Up to the tick that was added last.
  [[nodiscard]] TimeSplit split() const noexcept;

 private:
  void end_rest(TimeSplit& split) const noexcept;

  ToolChange tool_change_;
  TimeSplit split_{};
  TickRecord last_{};
  bool has_last_ = false;
  std::int64_t rest_ = 0;         // ticks of the present rest
  std::int32_t tool_before_ = 0;  // the rest
  bool has_cut_ = false;
};

}  // namespace kerf::program
