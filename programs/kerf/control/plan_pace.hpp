// How the planning side of a run goes beside its ticks: noted, or as a record has it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "programs/kerf/control/plan_record.hpp"

namespace kerf::program {

// Two threads. The one that plans looks at the ticks, and gives orders. In a run once more it looks
// only where the record looked, so it waits for the ticks until they are there; and the ticks wait
// until it waits. So no time passes for it but at its looks, as many ticks as then; the clock of
// such a run is the record.
class PlanPace {
 public:
  enum class Does : std::uint8_t { notes, repeats };
  // Notes into the record, or does once more what is in it.
  PlanPace(PlanRecord record, Does does)
      : record_(std::move(record)), emergency_tick_(record_.emergency_tick.value_or(kNone)) {
    if (does == Does::repeats) {
      record_.finish();
      repeated_.emplace(record_);
    }
  }
  PlanPace(const PlanPace&) = delete;
  PlanPace& operator=(const PlanPace&) = delete;

  [[nodiscard]] bool is_repeated() const noexcept { return repeated_.has_value(); }

  // The thread that plans. KernelOptions::plan_clock.
  bool look(std::int64_t ticks);
  // Somebody asked for it now.
  void note(std::string_view order);
  // The program was stopped, by no order.
  void note_end() { note(kEnd); }
  // The order that comes now; nothing: none does.
  std::optional<std::string> next_order();
  // Such an end comes now: it is taken.
  bool next_is_end();

  // The thread of the ticks, before each: waits until planning has done what it did by then. True:
  // an emergency stop came before this tick.
  bool begin_tick(std::int64_t tick);
  // One came before this tick. Waits for nothing.
  void note_emergency(std::int64_t tick) noexcept { emergency_tick_ = tick; }

  // Any thread. Nobody waits any more, and nothing more is noted.
  void end();
  // After end(). Of a run once more: as it was.
  [[nodiscard]] PlanRecord record() const;

 private:
  static constexpr std::int64_t kNone = -1;
  static constexpr std::int64_t kTakenBack = -1;  // KernelOptions::plan_clock
  static constexpr std::string_view kEnd = "end";

  PlanRecord record_;
  std::optional<PlanRecord::Reader> repeated_{};
  std::atomic<std::int64_t> emergency_tick_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t ticks_ = 0;
  bool has_begun_ = false;
  bool waits_ = false;  // the thread that plans, for the next tick
  bool is_over_ = false;
};

}  // namespace kerf::program
