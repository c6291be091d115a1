// Turns planned blocks into phases, and tracks how far emission has come.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <kerf/report.hpp>

#include "interp/motion.hpp"
#include "interp/outputs.hpp"
#include "lookahead/emit/emitted_items.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/window.hpp"
#include "profiles/time_law.hpp"

namespace kerf::lookahead {

// Emitted motion, in the order in which it runs. The pieces of a curve come before its phases.
struct Outbox {
  std::vector<interp::CurvePiece> pieces;
  std::vector<interp::LineChange> line_changes;  // come with the pieces of their curve
  std::vector<interp::Phase> phases;
  std::vector<interp::OutputChange> output_changes;  // before the first phase that counts them

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

// The time at which the next phase begins, as whole ticks and a remainder, so that it keeps its
// precision however long a program runs.
class PlanClock {
 public:
  explicit PlanClock(double period_s) : period_s_(period_s) {}

  [[nodiscard]] const interp::TickTime& now() const noexcept { return now_; }
  // Loses precision after days.
  [[nodiscard]] double now_s() const noexcept {
    return static_cast<double>(now_.tick) * period_s_ + now_.offset_s;
  }
  // The present tick, or the next one if time stands between two.
  [[nodiscard]] std::int64_t next_tick() const noexcept;

  // duration_s >= 0
  void advance(double duration_s) noexcept;
  // Moves on to next_tick(), as after a rest.
  void align_to_tick() noexcept;
  // Goes on from there; on a tick where only rounding parts them, so that a plan which ends there
  // is not over a tick before the next one begins.
  void set(const interp::TickTime& time) noexcept;

 private:
  double period_s_;
  interp::TickTime now_{};
};

class Emitter {
 public:
  // keeps: what was emitted can be taken back, up to forget_before().
  explicit Emitter(double period_s, bool keeps = false);

  // The change takes effect at the first tick on the block with this number, counted from 1.
  void change_at_block(std::uint64_t number, const interp::OutputChange& change);

  // The place on the block that is being emitted, or that comes next.
  [[nodiscard]] double s_mm() const noexcept { return place_.on_block ? place_.s_mm : 0.0; }
  [[nodiscard]] const PlanTotals& totals() const noexcept { return totals_; }

  void note(const PlanDegradation& degradation) noexcept;

  // Emits a phase from where the block's motion stands to s_end_mm. The block's pieces are emitted
  // with its first phase.
  void emit(const Block& block, const profiles::TimeLaw& law, double s_end_mm, Outbox& outbox);
  // A segment of the block ends at s_mm.
  void end_segment(const Block& block, double s_mm);
  // The block ends with its last segment.
  void end_block(Block&& block);
  // The block that is being emitted ends where its motion stands: this is what has been run of it.
  void end_block_here(Block&& block);
  // Time goes on there, at rest.
  void go_on_at(std::int64_t tick) noexcept { clock_.set({.tick = tick}); }
  // The last phase has ended at rest: time goes on at the next tick.
  void come_to_rest(Outbox& outbox);
  void emit_rest(const Rest& rest, Outbox& outbox);

  // Keeps the phases of the outbox from this one on. Call it once they are complete.
  void keep(const Outbox& outbox, std::size_t first);
  void forget_before(std::int64_t tick);
  [[nodiscard]] std::uint64_t oldest_curve() const noexcept;
  // The motion at a tick; a rest where none was emitted. Precondition: what was emitted is kept,
  // and reaches to the tick or ends at rest.
  [[nodiscard]] EmittedItems::Motion motion_at(std::int64_t tick) const;
  // What can be taken back. Precondition: it is kept.
  [[nodiscard]] const EmittedItems& kept() const { return *kept_; }
  // A new plan goes on from the motion, which may be on the first item that is ahead then;
  // EmittedItems::take_back.
  void take_back(const EmittedItems::Motion& motion, std::deque<Item>& ahead);
  // Goes back to what was emitted before take_back().
  void restore(Emitter&& before);
  // A copy has emitted what the tick side got.
  void note_sent_by(const Emitter& copy);
  [[nodiscard]] bool ends_at_rest() const { return kept_->ends_at_rest(); }
  // The number of the plan that is being emitted.
  [[nodiscard]] std::uint32_t plan() const noexcept { return plan_; }
  // It has been emitted before, under that number.
  void repeat_plan(std::uint32_t plan) noexcept {
    plan_ = plan;
    plans_ = std::max(plans_, plan);
  }
  // The present block goes on as its remainder, on which the motion is at s_mm.
  void begin_remainder(double s_mm) noexcept { place_.s_mm = s_mm; }
  [[nodiscard]] bool is_on_block() const noexcept { return place_.on_block; }
  // The present curve, or the one that comes next.
  [[nodiscard]] std::uint64_t next_curve() const noexcept {
    return place_.curve + (place_.on_block ? 0 : 1);
  }
  // On the present curve.
  [[nodiscard]] double curve_mm() const noexcept { return place_.curve_mm; }
  [[nodiscard]] const interp::TickTime& now() const noexcept { return clock_.now(); }
  // A rest of no duration, of no item, in the line; 0: in that of the motion or rest before.
  void emit_rest_here(std::uint32_t line, Outbox& outbox);

 private:
  struct OutputChangeAtBlock {
    std::uint64_t number = 0;
    interp::OutputChange change{};
  };

  void begin_block(const Block& block, Outbox& outbox);
  // Those of the block that has begun.
  void pass_block_changes();
  void drop_block_changes(std::uint64_t before);
  void emit_path(const Block& block, Outbox& outbox);
  void emit_change(const interp::OutputChange& change, Outbox& outbox);
  [[nodiscard]] interp::Phase rest_phase(double duration_s) const;

  PlanClock clock_;
  std::optional<EmittedItems> kept_;
  EmitPlace place_{};
  std::uint32_t plan_ = 0;   // that is being emitted
  std::uint32_t plans_ = 0;  // the highest number of one
  // What is on its way to the tick side stays there: the path, and what it switches.
  std::uint64_t curves_sent_ = 0;
  std::uint64_t output_changes_sent_ = 0;
  Window<OutputChangeAtBlock> block_changes_;  // place_.block_changes counts them from the first
  std::uint64_t block_changes_gone_ = 0;       // that are kept no more
  PlanTotals totals_{};
};

}  // namespace kerf::lookahead
