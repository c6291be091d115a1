// Turns planned blocks into phases, and tracks how far emission has come.
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

// Emitted motion, in the order in which it runs. The pieces of a curve come before its phases.
struct Outbox {
  std::vector<interp::CurvePiece> pieces;
  std::vector<interp::LineChange> line_changes;  // come with the pieces of their curve
  std::vector<interp::Phase> phases;
  std::vector<interp::OutputChangeAtTick> output_changes;  // by tick, which lies in the phases

  // Keeps its memory.
  void clear() noexcept {
    pieces.clear();
    line_changes.clear();
    phases.clear();
    output_changes.clear();
  }
};

// Totals of what has been emitted.
using kerf::PlanDegradation;
using kerf::PlanDegradations;
using kerf::PlanTotals;

struct Rest {
  double duration_s = 0.0;
  std::uint32_t line = 0;  // 0: that of the last motion
  bool ends_program = false;
  std::optional<interp::OutputChange> change{};
};

// The time at which the next phase begins, as whole ticks and a remainder, so that it keeps its
// precision however long a program runs.
class PlanClock {
 public:
  explicit PlanClock(double period_s) : period_s_(period_s) {}

  [[nodiscard]] const interp::TickTime& now() const noexcept { return now_; }
  // The present tick, or the next one if time stands between two.
  [[nodiscard]] std::int64_t next_tick() const noexcept;

  // duration_s >= 0
  void advance(double duration_s) noexcept;
  // Moves on to next_tick(), as after a rest.
  void align_to_tick() noexcept;

 private:
  double period_s_;
  interp::TickTime now_{};
};

class Emitter {
 public:
  explicit Emitter(double period_s) : clock_(period_s) {}

  // The change takes effect at the first tick on the block with this number, counted from 1.
  void change_at_block(std::uint64_t number, const interp::OutputChange& change);

  // The place on the block that is being emitted, or that comes next.
  [[nodiscard]] double s_mm() const noexcept { return block_begun_ ? s_mm_ : 0.0; }
  [[nodiscard]] const PlanTotals& totals() const noexcept { return totals_; }

  void note(const PlanDegradation& degradation) noexcept;

  // Emits a phase from where the block's motion stands to s_end_mm. The block's pieces are emitted
  // with its first phase.
  void emit(const Block& block, const profiles::TimeLaw& law, double s_end_mm, Outbox& outbox);
  // A segment of the block ends at s_mm.
  void end_segment(double s_mm);
  // The block ends with its last segment.
  void end_block(const Block& block);
  // The last phase has ended at rest: time goes on at the next tick.
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
  bool block_begun_ = false;  // a phase of the front block has been emitted
  std::uint64_t curve_ = 0;
  bool rests_ = false;  // X, Y and Z rest on it: it adds nothing to the path
  double s_mm_ = 0.0;
  double path_begin_mm_ = 0.0;  // of all curves before this one
  std::uint32_t line_ = 0;
  PlanTotals totals_{};
};

}  // namespace kerf::lookahead
