// The time that each constraint binds: the answer of --explain-speed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "programs/kerf/report/constraint_text.hpp"
#include "programs/kerf/report/tick_record.hpp"
#include "programs/kerf/speed_question.hpp"

namespace kerf::program {

struct LimitTime {
  Constraint limit{};
  std::int64_t ticks = 0;
};

// For one line of the program, over all the times it runs, or for the whole.
struct LineSpeed {
  std::uint32_t line = 0;
  std::int64_t ticks = 0;
  std::vector<LimitTime> limits;  // the longest first; they add up to ticks
};

// That much of a line's time.
struct LineLimitTime {
  std::uint32_t line = 0;
  Constraint limit{};
  std::int64_t ticks = 0;
};

struct TickSpeed {
  std::int64_t tick = 0;
  std::uint32_t line = 0;
  double v_mm_s = 0.0;
  Constraint limit{};
};

struct SpeedReport {
  LineSpeed whole{};
  std::int64_t stops = 0;         // how often it comes to rest
  std::vector<LineSpeed> lines;   // those that take the longest, or the one that was asked for
  std::optional<TickSpeed> tick;  // that was asked for
  std::vector<LineLimitTime> each_line;  // by line, then limit; where they were asked for
};

// Counts for each limit the periods that begin with it; they add up to the cycle time. Memory grows
// with the lines that run, 16 bytes for each limit of each.
class SpeedAccount {
 public:
  SpeedAccount(const SpeedQuestion& question, double period_s);

  void add(const TickRecord& record);
  [[nodiscard]] SpeedReport report() const;

 private:
  static std::vector<LineLimitTime> merged(std::vector<LineLimitTime> entries);

  SpeedQuestion question_;
  std::int64_t asked_tick_ = -1;
  std::optional<TickRecord> last_;
  std::vector<LineLimitTime> entries_;
  std::size_t merge_at_ = 4096;  // of entries_
  std::int64_t stops_ = 0;
  std::optional<TickSpeed> tick_;
};

}  // namespace kerf::program
