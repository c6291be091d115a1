// Plans motion over a window of blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "interp/outputs.hpp"
#include "lookahead/classical/classical_schedule.hpp"
#include "lookahead/emit/emitter.hpp"
#include "lookahead/emit/schedule.hpp"
#include "lookahead/event_time.hpp"
#include "lookahead/optimum/optimum_schedule.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/feed_override.hpp"
#include "lookahead/path/feed_scan.hpp"
#include "lookahead/path/plan_observer.hpp"
#include "lookahead/path/window.hpp"
#include "lookahead/plan_stop.hpp"
#include "parser/moves/move.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

struct PlannerSettings {
  PlanLimits limits{};
  profiles::Profile profile{profiles::ProfileKind::s_curve};
  std::size_t window_blocks = 1000;  // >= 2; at least 4 for the time optimum
  std::size_t window_cells = 3000;   // that the time optimum plans at once; >= 100
  // Cruises and dwells are emitted in parts of about this: what is planned is then as long as it is
  // asked for.
  double longest_phase_s = 0.1;
  // M0, M60, M6 and, where optional stops are on, M1 wait for resume(). Needs may_hold.
  bool waits = false;
  bool optional_stop = false;
  EventTime::Settings event_time{};
  bool may_hold = false;  // what was emitted is kept until it is run, so that it can be taken back
  std::shared_ptr<const PlanObserver> observer{};  // null: nobody is told
};

// After a rest that is farther nothing is planned yet that takes over there: nothing else could be
// asked for before the tool has come to it.
inline constexpr double kFarRest_s = 0.02;

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
  struct RestPlace {
    std::uint32_t line = 0;
    std::uint64_t run_block = 0;  // parser::Move::block; 0: of none
    parser::FollowedOverrides follows{};
  };
  void push_rest(double duration_s, const RestPlace& at);
  // The tool stops and waits for resume(), after the change where there is one. Precondition:
  // wants_block().
  void push_wait(const std::optional<interp::OutputChange>& change, WaitCause cause,
                 const RestPlace& at);
  [[nodiscard]] bool waits_at(parser::EventKind kind) const noexcept;
  // The same until the machine has answered. Precondition: wants_block(), or the block of its
  // motion was pushed last.
  void push_machine_wait(const RestPlace& at);
  // Of what is not pushed yet.
  void set_optional_stop(bool on) noexcept { settings_.optional_stop = on; }
  [[nodiscard]] bool stops_optionally() const noexcept { return settings_.optional_stop; }
  // The change takes effect once the tool is at rest; it rests for duration_s then. Precondition:
  // wants_block().
  void push_change_at_rest(const interp::OutputChange& change, const RestPlace& at,
                           double duration_s = 0.0);
  // The change takes effect at the first tick on the block that is pushed next.
  void push_change_at_motion(const interp::OutputChange& change);
  // The same at the first tick of what is pushed next, be it a rest.
  void push_change_at_next(const interp::OutputChange& change);
  // The program ends, at rest, after what has been pushed. Precondition: wants_block().
  void finish(std::uint32_t line);

  // EventTime::next_s, 0 where it waits for an answer.
  [[nodiscard]] RestTime rest_time(const parser::EventMove& event) noexcept;
  void note_wait(const PlanWait& wait) noexcept;
  [[nodiscard]] const PlanWaits& waits_pushed() const noexcept { return waits_pushed_; }

  // Plans everything pushed so far to a rest. Call it when the next move is late.
  void plan_to_rest();
  // A feed hold; where the tool rests and waits for the machine, and within a tap, it is refused:
  // ask again after that. A new plan that takes over at the tick or some ticks later and comes to
  // rest as soon as the order has it, or at the rest of the present plan if that is as near. The
  // outbox, which is empty before, gets its phases, and what they begin on; none where the program
  // has ended by then, or waits() at the rest of the present plan. What follows waits for resume().
  // Precondition: may_hold, it does not hold but by the feed. False: no way was found, and nothing
  // has changed; ask again with a later tick, or when more was emitted.
  bool hold(const StopOrder& order, Outbox& outbox);
  // From now on nothing begins to move that the feed stops: the plan is held there, at rest, and
  // goes on with resume(). What was emitted is not taken back.
  void stop_feed(const StoppedFeed& stopped) noexcept { stopped_feed_ = stopped; }
  // It is held there.
  [[nodiscard]] bool is_held_by_feed() const noexcept { return held_ && held_->by_feed; }
  // The same, and the feed stops it no more.
  [[nodiscard]] bool feed_lets_go() const noexcept {
    return is_held_by_feed() && !stopped_feed_.stops(*held_->by_feed);
  }
  // As hold(), because the feed stops: what was emitted and follows it, or the motion that begins
  // so after a rest that is near. False as well where there is none; stop_feed() sees to all that
  // is not emitted yet.
  bool hold_feed(const StopOrder& order, Outbox& outbox);
  // The end of what was emitted before the plan that is to take over is lost: it is no way to rest.
  void cut_plan_before() { before_->is_cut = true; }
  // Whether the tick side took the plan that was to take over. If not, there is none any more; ask
  // for another one: what was emitted before is run to its end, and where that is in motion nothing
  // follows.
  void settle(bool accepted);
  // Goes on from the rest of a hold, on the same path, or from a wait. Precondition: settle().
  void resume();
  // A way to rest that the tick side may take at a tick, at this one or some later, if nothing else
  // was handed over by then.
  struct PlannedStopAhead {
    PlanStop stop{};
    std::uint32_t plan = 0;  // its number
    Outbox outbox{};
  };
  // Nothing: none was found, as in find_stop(). Precondition: as hold().
  std::optional<PlannedStopAhead> stop_ahead(std::int64_t tick);
  // The tick side has taken it: the plan goes on from its rest. Its phases, for the record.
  // Precondition: settle().
  Outbox follow_stop_ahead(const PlannedStopAhead& taken);
  // The tick side has braked the motion of a probe, at the tick, along the laws, as a plan of that
  // number, and rests. What was left of the block is dropped, and the wait for the machine after
  // it is over. The phases, for the record, without those of the rest. Precondition: settle().
  struct ProbeStop {
    std::int64_t tick = 0;
    std::uint32_t plan = 0;
    std::span<const profiles::CellLaw> laws{};
    std::int64_t rest_tick = 0;
  };
  Outbox follow_probe(const ProbeStop& stop);
  // Goes on with other feedrates, or with or without a wait at each block's end, from a tick or
  // some later, in motion where a plan from there is found, else from the rest that hold() would
  // find; the profile of the settings is back after the next rest or cruise. The outbox, which is
  // empty before, gets phases up to until_tick; they go on as the plan of emit() does. None where
  // nothing was emitted that could change. Precondition: as hold(), but that it may be held.
  struct PlanChange {
    FeedOverride by{};
    // The tool rests and waits at the junction after each block of the program; a curve that
    // stands for several is one.
    bool single_block = false;
    std::int64_t tick = 0;
    std::int64_t until_tick = 0;
    bool needs_stop = false;  // a way to rest, too, where what was emitted does not end at rest
  };
  struct ChangedPlan {
    std::optional<PlannedStopAhead> stop{};
    // Up to this curve the motion may still slow down from feedrates above the new ones.
    std::uint64_t slows_to_curve = 0;
  };
  // Nothing: as hold() false.
  std::optional<ChangedPlan> change_plan(const PlanChange& change, Outbox& outbox);
  [[nodiscard]] const FeedOverride& feed_override() const noexcept { return by_; }
  // Nothing more is emitted: a plan that takes over is not settled yet; or it was refused, and what
  // was emitted before ends in motion, so that another has to take over.
  [[nodiscard]] bool awaits_answer() const noexcept { return before_.has_value() || is_cut_; }
  // As hold(), but the program ends at that rest.
  bool stop(const StopOrder& order, Outbox& outbox);
  // Ends the program where it is held. Precondition: is_held(), settle().
  void stop_held();
  [[nodiscard]] bool is_held() const noexcept { return held_.has_value(); }
  // What was emitted ends in a wait, and its number (Phase::wait).
  [[nodiscard]] bool waits() const noexcept { return waits_; }
  // It is for resume(), not for the machine.
  [[nodiscard]] bool waits_for_resume() const noexcept { return waits_ && !asks_machine_; }
  [[nodiscard]] std::uint32_t wait() const noexcept { return waits_emitted_; }
  // Where the plan emitted so far ends; time goes on from there.
  [[nodiscard]] std::int64_t emitted_until_tick() const noexcept { return emitter_.now().tick; }
  // Of the program, where the motion rests for it at that tick; 0: it does not, or no farther is
  // planned.
  [[nodiscard]] std::uint64_t rest_block_at(std::int64_t tick) const {
    const auto motion = emitter_.kept().at(tick);
    return motion ? motion->phase.rest_block : 0;
  }
  // What was emitted ends at rest.
  [[nodiscard]] bool ends_at_rest() const { return emitter_.ends_at_rest(); }
  // The number of the plan that is being emitted.
  [[nodiscard]] std::uint32_t plan() const noexcept { return emitter_.plan(); }
  // The ticks before this one have been run.
  void forget_before(std::int64_t tick) { emitter_.forget_before(tick); }
  // The first curve that may be taken back; curves are counted from 1.
  [[nodiscard]] std::uint64_t oldest_curve() const noexcept { return emitter_.oldest_curve(); }

  // Appends motion or a rest. False: nothing is ready; push a block or finish.
  bool emit(Outbox& outbox);

  [[nodiscard]] const PlanTotals& totals() const noexcept { return emitter_.totals(); }

 private:
  [[nodiscard]] bool has_room() const noexcept;
  void take(Block block);
  // From what was taken back, as much as there is room for.
  void take_waiting();
  bool emit_next(Outbox& outbox);
  // What is emitted next begins to move from rest, and the feed stops it.
  [[nodiscard]] bool is_stopped_by_feed() const;
  void hold_by_feed(Outbox& outbox);
  [[nodiscard]] std::optional<PlanStop> feed_stop_by(const StopOrder& order) const;
  // Not within a tap.
  [[nodiscard]] bool may_hold_at(const EmittedItems::Motion& motion) const;
  void emit_rest(Outbox& outbox);
  void end_with(const Rest& rest);
  [[nodiscard]] std::size_t ready_blocks() const;
  [[nodiscard]] OptimumSchedule::Settings optimum_settings() const;
  [[nodiscard]] ClassicalSchedule::Settings classical_settings() const;
  [[nodiscard]] std::unique_ptr<Schedule> new_schedule() const;
  bool hold_at(const PlanStop& stop, Outbox& outbox);
  [[nodiscard]] std::optional<PlanStop> find_our_stop(const StopOrder& order) const;
  // What waits up to the wait for the machine, and that: the block that the tool is on ends at
  // s_mm. The wait.
  Rest drop_to_machine_wait(double s_mm);
  // Takes back what follows the motion.
  // Of the items that wait then, so many may change before the plan is settled.
  void take_back(const EmittedItems::Motion& from, std::size_t changing);
  // In program order: a wait comes before it where a block of the program ends in single block.
  void accept(Item item);
  void accept_rest(Rest rest);
  static bool is_step(const Item& item);
  [[nodiscard]] bool steps_before(const Item& next) const;
  void end_with_step();
  // Of what waits: a wait after the first block of the program that ends with this item or later.
  void step_behind(std::size_t item);
  void forget_steps();
  // The limits of what waits, from this one on.
  void limit_waiting(std::size_t first = 0);
  // False: no plan from there was found, and nothing has changed.
  struct InMotion {
    const PlanStop* stop = nullptr;
    std::optional<Block> before{};
  };
  bool go_on_in_motion(InMotion from, const PlanChange& change, ChangedPlan& changed,
                       Outbox& outbox);
  void change_at_rest(const PlanChange& change);
  // With a first part of what follows where the rest may be over at once. Where nothing is found
  // that a way to rest goes on from, the plan ends at that rest.
  void go_on_from_rest(const std::vector<BrakingPart>& parts, const PlanChange& change,
                       ChangedPlan& changed, Outbox& outbox);
  void go_back(const Emitter& emitter, const std::deque<Item>& waiting);
  bool begin_in_motion(InMotion from);
  bool take_blocks_in_motion(std::size_t taken);
  void stand_in();
  // Where the stand-in cruises on a block, its junctions are far and the profile of the settings
  // can go on from there: it does.
  void return_to_profile(const interp::Phase& phase);
  // Those of the change, for what waits.
  void take_modes(const PlanChange& change);
  // False: there is no motion, or no way to rest after it.
  bool emit_first_part(const PlanChange& change, ChangedPlan& changed, Outbox& outbox);
  // Of the blocks that wait, those on which the motion may be faster than they allow: how many.
  std::size_t let_slow_down(const OptimumSchedule::Begin& from);
  // What is left of the block that the tool is on waits in its place, from so far before it on.
  void begin_rest_of_block(double before_mm = 0.0);
  // Up to a rest. Whole.
  [[nodiscard]] std::vector<const Block*> blocks_ahead() const;
  // All that is in the window waits again.
  void empty_window();
  // What waited before the plan that is not settled yet.
  void wait_as_before();

  PlannerSettings settings_;

  std::size_t window_blocks_;
  ScanFor scan_for_;
  std::unique_ptr<Schedule> schedule_;
  Window<Block> blocks_;  // the front one is being emitted
  bool to_rest_ = false;  // the whole window may be emitted
  bool rest_pending_ = false;
  Rest rest_{};  // what is left of it
  double rest_part_s_;
  std::uint64_t pushed_blocks_ = 0;
  std::vector<interp::OutputChange> changes_for_next_;
  std::deque<Item> waiting_;  // was taken back, and goes before what comes
  struct Held {
    std::optional<parser::FollowedOverrides> by_feed{};  // what it holds follows these
  };
  std::optional<Held> held_{};
  StoppedFeed stopped_feed_{};
  bool waits_ = false;
  bool asks_machine_ = false;  // what it waits for, if it does
  std::uint32_t waits_emitted_ = 0;
  PlanWaits waits_pushed_{};
  EventTime event_time_;  // after what was pushed
  bool stops_ = false;    // at the rest of the plan that is not settled yet
  // The place in the program of what was taken last, or the tool is on; nothing: none, or it
  // was taken back.
  struct ProgramPlace {
    std::uint32_t line = 0;
    std::uint64_t run_block = 0;  // 0: of a rest, which has none
    std::uint32_t end_line = 0;   // where it ends
    std::uint64_t end_run_block = 0;
  };
  struct Before {
    Emitter emitter;
    std::deque<Item> changing;           // the first that waited
    std::size_t others = 0;              // that waited after them
    std::unique_ptr<Schedule> schedule;  // its end takes time, and the plan may be urgent
    bool waits = false;
    std::uint32_t waits_emitted = 0;
    bool asks_machine = false;
    FeedOverride by{};
    bool single_block = false;
    std::optional<ProgramPlace> last{};
    bool is_cut = false;
  };
  std::optional<Before> before_;  // the plan that is not settled yet
  bool is_cut_ = false;           // what was emitted ends in motion, and its plan is gone
  FeedOverride by_{};
  bool single_block_ = false;
  // A curve that stands for several lines counts as the first of them, so a block ends with it.
  static ProgramPlace place_of(const Item& item);
  // Nothing: after a wait none is needed.
  static std::optional<ProgramPlace> place_behind(const Item& item);
  // After what was emitted.
  [[nodiscard]] std::optional<ProgramPlace> place_emitted() const;
  static Rest step_at_end_of(const ProgramPlace& place);
  static bool is_same_block(const ProgramPlace& before, const ProgramPlace& after);
  std::optional<ProgramPlace> last_{};
  // A time optimum, for the profile of the settings, to the next rest or cruise.
  bool stands_in_ = false;
  std::int64_t next_return_tick_ = 0;
  std::int64_t between_returns_ = 0;  // ticks
  Emitter emitter_;
};

// Precondition of both: planner.wants_block().
// A dwell or an event becomes a rest, or a change with the next motion.
RestTime push_pause(const parser::Move& pause, Planner& planner);
// changes: those that take effect at the first tick on the block.
void push_block(Block block, const std::vector<parser::EventMove>& changes, Planner& planner);

}  // namespace kerf::lookahead
