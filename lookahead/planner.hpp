// Blocks to motion: the window of the look-ahead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "interp/outputs.hpp"
#include "lookahead/emit/emitter.hpp"
#include "lookahead/emit/schedule.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/feed_scan.hpp"
#include "lookahead/path/window.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

struct PlannerSettings {
  PlanLimits limits{};
  profiles::Profile profile{profiles::ProfileKind::s_curve};
  std::size_t window_blocks = 1000;  // >= 2; the time optimum takes 4 at the least
  std::size_t window_cells = 3000;   // of the time optimum: planned at once; >= 100
  // A cruise leaves in parts of this duration, so that a stop need not wait for its end.
  double longest_cruise_s = 0.1;
};

// Blocks go in while wants_block(); motion comes out of emit(), a part of a schedule a call.
// Whatever has been emitted can be followed by a stop: the window always ends at rest.
class Planner {
 public:
  explicit Planner(const PlannerSettings& settings);

  // How the curves of blocks are to be scanned for the profile (append_blocks).
  [[nodiscard]] ScanFor scan_for() const noexcept { return scan_for_; }
  // False: emit() before the next move. The blocks of one move may exceed the window.
  [[nodiscard]] bool wants_block() const noexcept;
  void push(Block block);
  // The tool rests for duration_s (0 for an event) once it has come to a stop. Precondition:
  // wants_block().
  void push_rest(double duration_s, std::uint32_t line);
  // The change comes once the tool is at rest. Precondition: wants_block().
  void push_change_at_rest(const interp::OutputChange& change, std::uint32_t line);
  // The change comes at the first tick on the block that is pushed next.
  void push_change_at_motion(const interp::OutputChange& change);
  // The program ends at rest after what was pushed. Precondition: wants_block().
  void finish(std::uint32_t line);

  // Everything pushed so far may be emitted; it ends at rest. For when no further move comes in
  // time.
  void plan_to_rest();
  // Lets the motion end at rest as soon as the limits allow after what was emitted, and the program
  // with it. The tool stays on the path. Nothing happens once the program's end was emitted.
  void stop();

  // Appends some motion, or a rest. False: nothing is ready; push or finish.
  bool emit(Outbox& outbox);

  [[nodiscard]] const PlanTotals& totals() const noexcept { return emitter_.totals(); }

 private:
  std::size_t window_blocks_;
  ScanFor scan_for_;
  std::unique_ptr<Schedule> schedule_;
  Window<Block> blocks_;  // front: the one being emitted
  bool to_rest_ = false;  // everything in the window may leave: it ends at rest
  bool rest_pending_ = false;
  Rest rest_{};
  std::uint64_t pushed_blocks_ = 0;
  Emitter emitter_;
};

}  // namespace kerf::lookahead
