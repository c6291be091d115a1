// Where the emission of motion stands: on which block, how far, and when.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <kerf/report.hpp>

#include "interp/motion.hpp"
#include "interp/outputs.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/window.hpp"
#include "profiles/time_law.hpp"

namespace kerf::lookahead {

// Planned motion in the order in which it runs: pieces of a curve before the phases on it.
struct Outbox {
  std::vector<interp::CurvePiece> pieces;
  std::vector<interp::LineChange> line_changes;  // of a curve, with its pieces
  std::vector<interp::Phase> phases;
  std::vector<interp::OutputChangeAtTick> output_changes;  // by tick, which lies in the phases

  // For the next of it, in the same memory.
  void clear() noexcept {
    pieces.clear();
    line_changes.clear();
    phases.clear();
    output_changes.clear();
  }
};

// Of what was emitted.
using kerf::PlanDegradation;
using kerf::PlanDegradations;
using kerf::PlanTotals;

struct Rest {
  double duration_s = 0.0;
  std::uint32_t line = 0;  // 0: that of the last motion
  bool ends_program = false;
  std::optional<interp::OutputChange> change{};
};

// The time at which planned motion begins. Counts whole ticks beside the rest of one, so that it
// does not wear out.
class PlanClock {
 public:
  explicit PlanClock(double period_s) : period_s_(period_s) {}

  [[nodiscard]] const interp::TickTime& now() const noexcept { return now_; }
  // The tick that is now, or the first one after it.
  [[nodiscard]] std::int64_t next_tick() const noexcept;

  // duration_s >= 0
  void advance(double duration_s) noexcept;
  // On to next_tick(), as after a rest.
  void align_to_tick() noexcept;

 private:
  double period_s_;
  interp::TickTime now_{};
};

class Emitter {
 public:
  explicit Emitter(double period_s) : clock_(period_s) {}

  // The change comes at the first tick on the block with this number, counted from 1.
  void change_at_block(std::uint64_t number, const interp::OutputChange& change);

  // False: the front block's first phase is still to come.
  [[nodiscard]] bool block_begun() const noexcept { return block_begun_; }
  // On the block that is being emitted or comes next.
  [[nodiscard]] double s_mm() const noexcept { return block_begun_ ? s_mm_ : 0.0; }
  [[nodiscard]] const PlanTotals& totals() const noexcept { return totals_; }

  void note(const PlanDegradation& degradation) { totals_.degradations.add(degradation); }

  // The block's motion from where it stands to s_end_mm. Its pieces leave with the first phase.
  void emit(const Block& block, const profiles::TimeLaw& law, double s_end_mm, Outbox& outbox);
  // A segment within the block is done at s_mm.
  void end_segment(double s_mm);
  // The block's last segment is done, and the block.
  void end_block(const Block& block);
  // The motion has come to rest with the last phase: time goes on at the next tick.
  void come_to_rest(Outbox& outbox);
  void emit_rest(const Rest& rest, Outbox& outbox);

 private:
  struct OutputChangeAtBlock {
    std::uint64_t number = 0;
    interp::OutputChange change{};
  };

  void begin_block(const Block& block, Outbox& outbox);

  PlanClock clock_;
  Window<OutputChangeAtBlock> output_changes_;
  bool block_begun_ = false;
  std::uint64_t curve_ = 0;
  bool rests_ = false;  // on it X, Y and Z rest: it adds nothing to the path
  double s_mm_ = 0.0;
  double path_begin_mm_ = 0.0;  // of all curves before this one
  std::uint32_t line_ = 0;
  PlanTotals totals_{};
};

}  // namespace kerf::lookahead
