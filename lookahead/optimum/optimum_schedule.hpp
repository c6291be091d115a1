// The time optimum over a window of cells: the schedule of the profile time-optimal.
#pragma once

#include <cstddef>
#include <memory>

#include "lookahead/emit/schedule.hpp"
#include "lookahead/optimum/begin_in_motion.hpp"
#include "lookahead/optimum/classical_run.hpp"
#include "lookahead/optimum/fallback.hpp"
#include "lookahead/optimum/grid/waiting_cells.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"
#include "lookahead/optimum/window_search.hpp"
#include "lookahead/path/plan_observer.hpp"

namespace kerf::lookahead {

// A plan covers the known cells up to the next stop, at most kCellsOfPlan, for it is to be found
// soon, or window_cells where it would brake for its end for long. Shortly before it begins to
// brake for the end of the window, but not before half of it has been emitted, it is planned anew
// from the tool's place, with the blocks that have come since. The cells that two plans share are
// the same, so the rest of the old plan is a feasible start for the new one. Where the search finds
// no plan that keeps the limits, it is tried over fewer cells. Where it finds none from a place in
// motion, the old plan is kept and the search begins again farther on; at the last it ends at rest.
// Where it finds none from rest, the classical plan is the fallback over whole blocks, if it is
// faster; else the path is cut in two by a rest at its sharpest place, a few times at the most, and
// a plan that still exceeds a limit is slowed down. Each of these but the first is noted as a
// degradation.
//
// Lines that are independent of each other (independent_line.hpp) are planned by the S-curve, which
// is their optimum in closed form: all of them from a rest to the next, or as far as the window
// reaches, and then whatever follows up to that rest.
class OptimumSchedule final : public Schedule {
 public:
  struct Settings {
    PlanLimits limits{};
    std::size_t window_cells = 3000;
    std::size_t ready_blocks =
        500;  // ClassicalSchedule::Settings; a full window holds twice as many
    // A cell is emitted in parts no longer than about this.
    double longest_phase_s = 0.1;
    bool takes_classical = true;                     // where that is faster
    std::shared_ptr<const PlanObserver> observer{};  // null: nobody is told
  };

  explicit OptimumSchedule(const Settings& settings);

  // A motion that this plan goes on from.
  using Begin = BeginInMotion;
  // Push the blocks with this one where a motion goes on, as far as they are known, and call
  // begin(). closed: a rest follows them. False: no plan was found. passed_mm_s: at which the
  // motion has just passed the junction before the block; 0: it has not.
  void push_in_motion(const Window<Block>& blocks, double passed_mm_s = 0.0);
  [[nodiscard]] bool begin(const Begin& from, bool closed, Window<Block>& blocks);

  void push(const Window<Block>& blocks) override;
  [[nodiscard]] bool empty() const override;
  [[nodiscard]] bool has_room() const override;
  bool emit(Window<Block>& blocks, Supply supply, Emitter& emitter, Outbox& outbox) override;

 private:
  [[nodiscard]] std::size_t cells_left() const { return plan_.cells().size() - place_.cell; }
  // That the next plan takes, at the most.
  [[nodiscard]] std::size_t max_cells() const;
  [[nodiscard]] bool is_to_be_renewed() const;
  void plan(Window<Block>& blocks, Emitter& emitter);
  // Hands all blocks up to the next rest to the classical schedule, those to come among them.
  void follow_classical(const Window<Block>& blocks, profiles::ProfileKind profile);
  // What was found from a rest in front of a block, up to the end of a block. Where a search on a
  // short curve did not end well, or left off within a few cells before a rest, all of that is
  // planned to see how long it takes.
  [[nodiscard]] PlannedCells tried_to_block_end(const FoundPlan& found, const WindowSearch& search,
                                                const Window<Block>& blocks) const;
  // What was found is the plan from now on. Precondition: there is a plan.
  void adopt(FoundPlan found);
  [[nodiscard]] WindowSearch search(const Window<Block>& blocks) const;
  void try_again_later(const Window<Block>& blocks, Emitter& emitter);
  // Hands these blocks to the classical schedule, from rest to rest.
  void fall_back(const Fallback& fallback, const Window<Block>& blocks, Emitter& emitter);
  // Of what was found: what is found up to a rest at its sharpest place, or up to one before that.
  [[nodiscard]] FoundPlan search_with_cut(FoundPlan found, const WindowSearch& search,
                                          const Window<Block>& blocks, Emitter& emitter);
  // Of the first waiting cells, but for those at both ends.
  [[nodiscard]] std::size_t sharpest(std::size_t count) const;
  // Notes that the plan from the first waiting cell on was slowed down.
  void note_slow_plan(const Window<Block>& blocks, Emitter& emitter) const;
  // Notes a stop at the end of the cell.
  void note_stop(const Cell& cell, const Window<Block>& blocks, Emitter& emitter) const;
  void emit_cell(Window<Block>& blocks, Emitter& emitter, Outbox& outbox);

  Settings settings_;
  ClassicalRun classical_;  // independent lines, and blocks on which it is faster or stands in
  WaitingCells waiting_;
  OptimalPlan plan_;
  PlanPlace place_{};      // on plan_: comes next
  std::size_t renew_ = 0;  // from this cell of plan_ on it is planned anew
  bool plan_ends_at_stop_ = true;
  std::size_t window_brake_ = 0;  // from this cell of plan_ on it brakes for the end of the window
  bool brakes_long_ = false;      // for that
};

}  // namespace kerf::lookahead
