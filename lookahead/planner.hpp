// Blocks to motion: the window of the look-ahead.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "interp/motion.hpp"
#include "interp/outputs.hpp"
#include "lookahead/block.hpp"
#include "lookahead/plan_clock.hpp"
#include "lookahead/velocity_pass.hpp"
#include "lookahead/window.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

// Planned motion in the order in which it runs: pieces of a curve before the phases on it.
struct Outbox {
  std::vector<interp::PathPiece> pieces;
  std::vector<interp::Phase> phases;
  std::vector<interp::SwitchAtTick> switches;  // by tick, which lies in the phases
};

struct PlannerSettings {
  PlanLimits limits{};
  profiles::Profile profile{profiles::ProfileKind::s_curve};
  std::size_t window_blocks = 1000;  // >= 2
  // A cruise leaves in parts of this duration, so that a stop need not wait for its end.
  double longest_cruise_s = 0.1;
};

// Of what was emitted.
struct PlanTotals {
  std::uint64_t blocks = 0;
  std::uint64_t spans = 0;
  double path_length_mm = 0.0;
  std::int64_t ticks = 0;
};

// Blocks go in while wants_block(); motion comes out of emit(), one span a call. A span is emitted
// once half a window of blocks is known behind it, or once the program rests there anyway. Whatever
// has been emitted can be followed by a stop: the window always ends at rest. Amortised each block
// is visited twice by the backward pass and once by the forward pass, whatever the length of the
// program.
class Planner {
 public:
  explicit Planner(const PlannerSettings& settings);

  // False: emit() before the next move. The blocks of one move may exceed the window.
  [[nodiscard]] bool wants_block() const noexcept;
  void push(Block block);
  // The tool rests for duration_s (0 for an event) once it has come to a stop. Precondition:
  // wants_block().
  void push_rest(double duration_s, std::uint32_t line);
  // The change comes once the tool is at rest. Precondition: wants_block().
  void push_switch_at_rest(const interp::Switch& change, std::uint32_t line);
  // The change comes at the first tick on the block that is pushed next.
  void push_switch_at_motion(const interp::Switch& change);
  // The program ends at rest after what was pushed. Precondition: wants_block().
  void finish(std::uint32_t line);

  // Everything pushed so far may be emitted; it ends at rest. For when no further move comes in
  // time.
  void drain();
  // Lets the motion end at rest as soon as the limits allow after what was emitted, and the program
  // with it. The tool stays on the path. Nothing happens once the program's end was emitted.
  void stop();

  // Appends the motion of one span, of a part of it, or of a rest. False: nothing is ready; push or
  // finish.
  bool emit(Outbox& outbox);

  [[nodiscard]] const PlanTotals& totals() const noexcept { return totals_; }

 private:
  struct Rest {
    double duration_s = 0.0;
    std::uint32_t line = 0;  // 0: that of the last motion
    bool ends_program = false;
    std::optional<interp::Switch> change{};
  };
  struct SwitchAtBlock {
    std::uint64_t block = 0;  // counts the blocks that were pushed, from 1
    interp::Switch change{};
  };

  void join_to_last(const Block& block);
  void append_spans(const Block& block);
  void plan_window();
  void emit_span(Outbox& outbox);
  void emit_plan(Outbox& outbox, const SpanPlan& plan);
  void leave_span();
  void begin_block(Outbox& outbox);
  void emit_switches(Outbox& outbox);
  void emit_phase(Outbox& outbox, const profiles::Transition& law, double s_end_mm);
  void emit_rest(Outbox& outbox);

  PlannerSettings settings_;
  Window<Block> blocks_;  // front: the one being emitted
  Window<WindowSpan> window_;
  std::size_t ready_spans_ = 0;  // of window_, planned and allowed to leave
  bool draining_ = false;        // everything in the window may leave: it ends at rest
  bool rest_pending_ = false;
  Rest rest_{};
  std::uint64_t pushed_blocks_ = 0;
  Window<SwitchAtBlock> switches_;

  // Where emission stands.
  bool block_begun_ = false;
  std::uint64_t curve_ = 0;
  bool rests_ = false;  // on it X, Y and Z rest: it adds nothing to the path
  double v_mm_s_ = 0.0;
  double s_mm_ = 0.0;           // on the curve
  double path_begin_mm_ = 0.0;  // of all curves before this one
  std::uint32_t line_ = 0;
  PlanClock clock_;
  PlanTotals totals_{};
};

}  // namespace kerf::lookahead
