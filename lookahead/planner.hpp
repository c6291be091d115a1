// Plans motion over a window of blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "interp/outputs.hpp"
#include "lookahead/emit/emitter.hpp"
#include "lookahead/emit/schedule.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/feed_scan.hpp"
#include "lookahead/path/window.hpp"
#include "parser/moves/move.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

struct PlannerSettings {
  PlanLimits limits{};
  profiles::Profile profile{profiles::ProfileKind::s_curve};
  std::size_t window_blocks = 1000;  // >= 2; at least 4 for the time optimum
  std::size_t window_cells = 3000;   // that the time optimum plans at once; >= 100
  // Cruises and dwells are emitted in parts of about this, so that a stop need not wait for the
  // end.
  double longest_phase_s = 0.1;
};

// Push blocks while wants_block() is true, and call emit() for motion; each call emits a part of
// the plan. The window always ends at rest, so a stop can follow whatever has been emitted.
class Planner {
 public:
  explicit Planner(const PlannerSettings& settings);

  // The scan that append_blocks needs for this profile.
  [[nodiscard]] ScanFor scan_for() const noexcept { return scan_for_; }
  // False: call emit() before the next move. All blocks of one move may be pushed, even beyond the
  // window.
  [[nodiscard]] bool wants_block() const noexcept;
  void push(Block block);
  // The tool stops and rests for duration_s (0 for an event). Precondition: wants_block().
  void push_rest(double duration_s, std::uint32_t line);
  // The change takes effect once the tool is at rest. Precondition: wants_block().
  void push_change_at_rest(const interp::OutputChange& change, std::uint32_t line);
  // The change takes effect at the first tick on the block that is pushed next.
  void push_change_at_motion(const interp::OutputChange& change);
  // The program ends, at rest, after what has been pushed. Precondition: wants_block().
  void finish(std::uint32_t line);

  // Plans everything pushed so far to a rest. Call it when the next move is late.
  void plan_to_rest();
  // Stops as soon as the limits allow after what has been emitted, and ends the program. The tool
  // stays on the path. Does nothing once the program's end has been emitted.
  void stop();

  // Appends motion or a rest. False: nothing is ready; push a block or finish.
  bool emit(Outbox& outbox);

  [[nodiscard]] const PlanTotals& totals() const noexcept { return emitter_.totals(); }

 private:
  void emit_rest(Outbox& outbox);
  void end_with(const Rest& rest);

  std::size_t window_blocks_;
  ScanFor scan_for_;
  std::unique_ptr<Schedule> schedule_;
  Window<Block> blocks_;  // the front one is being emitted
  bool to_rest_ = false;  // the whole window may be emitted
  bool rest_pending_ = false;
  Rest rest_{};  // what is left of it
  double rest_part_s_;
  std::uint64_t pushed_blocks_ = 0;
  Emitter emitter_;
};

// Precondition of both: planner.wants_block().
// A dwell or an event becomes a rest, or a change with the next motion.
void push_pause(const parser::Move& pause, Planner& planner);
// changes: those that take effect at the first tick on the block.
void push_block(Block block, const std::vector<parser::EventMove>& changes, Planner& planner);

}  // namespace kerf::lookahead
