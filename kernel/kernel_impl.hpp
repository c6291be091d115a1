// What a Kernel is made of.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <kerf/kernel.hpp>

#include "interp/interpolator.hpp"
#include "interp/tick_calls.hpp"
#include "kernel/delivery.hpp"
#include "kernel/pipeline.hpp"
#include "kernel/program_notes.hpp"
#include "kernel/tick_judge.hpp"

namespace kerf {

// Planning: text becomes a plan as far as the horizon, and what is in the queue is committed to the
// tick side. With a planning thread each commit brings a way to rest after it (hand_over), so the
// tick side never runs out of plan; if it has taken that way, planning goes on from its rest
// (follow_stop_ahead). A hold or a stop is a plan that takes over from the present one some
// milliseconds later (try_hold, try_change_plan); the tick side answers whether it came in time
// (follow_commands).
class KERF_LOCAL Kernel::Impl {
 public:
  Impl(const MachineSettings& settings, const KernelOptions& options)
      : tells_(options.tells_operator),
        notes_({.limits = settings.limits,
                .nominal = options.nominal,
                .blocks_before =
                    options.start_in_program ? options.start_in_program->blocks_before : 0}),
        period_s_(settings.limits.period_s),
        pipeline_(
            {.settings = settings,
             .options = options,
             .path = {.asks_machine = options.asks_machine, .observer = tells_ ? &notes_ : nullptr},
             .may_hold = true}),
        interpolator_(queue_, settings.limits.period_s, options.start_mm,
                      options.start_extra_rad_mm, settings.limits),
        judge_({.limits = settings.limits,
                .binds_jerk = options.profile.kind != profiles::ProfileKind::trapezoid,
                .has_extra_axes = settings.program.extra_axes != 0}),
        horizon_ticks_(
            static_cast<std::int64_t>(std::ceil(options.horizon_s / settings.limits.period_s))),
        margin_ticks_(static_cast<std::int64_t>(std::ceil(kMargin_s / settings.limits.period_s))),
        first_part_ticks_(
            static_cast<std::int64_t>(std::ceil(kFirstPart_s / settings.limits.period_s))),
        announced_ticks_(
            static_cast<std::int64_t>(std::ceil(kAnnounced_s / settings.limits.period_s))),
        keeps_stop_(!options.one_thread),
        begins_with_(options.begins_with),
        plan_clock_(options.plan_clock) {
    interpolator_.begin_with(outputs_at_begin(options));
  }

  void feed(std::string_view text) { pipeline_.feed(text); }
  void finish() { pipeline_.finish(); }
  void refuse(diagnostics::Diagnostic fault) { pipeline_.refuse(std::move(fault)); }

  bool plan();
  ReadStatus read() { return pipeline_.read(); }

  TickStatus tick(Setpoint& setpoint) noexcept;

  [[nodiscard]] bool has_fault() const noexcept {
    return broken_ || plan_fault_ || judge_.excess().figure != TickExcess::Figure::none;
  }

  void reach_tick();

  [[nodiscard]] bool needs_plan() noexcept { return interpolator_.needs_plan(); }
  void make_room() noexcept { interpolator_.pass_what_is_over(); }

  TickStatus next(Setpoint& setpoint);

  [[nodiscard]] bool runs_low() const {
    return committed_until_tick_ - now() <= horizon_ticks_ / 2;
  }

  void plan_to_rest();

  void emergency_stop() noexcept { interpolator_.emergency_stop(); }

  void hold();
  void resume();
  void stop() {
    stops_ = true;
    interpolator_.watch().ignore_probe();
    hold();
  }
  bool set_overrides(const Overrides& overrides);
  bool set_feed_inputs(const FeedInputs& inputs);
  void set_single_block(bool on);
  void set_optional_stop(bool on) { pipeline_.set_optional_stop(on); }
  bool set_tool(const Tool& tool);
  [[nodiscard]] bool start_counts_on_tools() const {
    return pipeline_.path().start_counts_on_tools();
  }
  void set_block_delete(const BlockDelete& switches) { pipeline_.set_block_delete(switches); }
  [[nodiscard]] const Overrides& overrides() const noexcept { return overrides_; }

  void set_program_inputs(const ProgramInputs& inputs) noexcept {
    interpolator_.watch().set_inputs(inputs);
  }
  [[nodiscard]] bool asks_machine() noexcept { return interpolator_.watch().asked() != nullptr; }
  [[nodiscard]] ProgramNotes& notes() noexcept { return notes_; }
  [[nodiscard]] ProgramState state_left() const;
  [[nodiscard]] std::optional<RunFault> fault() const {
    const std::optional<RunFault>& of_plan = pipeline_.check().fault();
    return of_plan ? of_plan : describe(judge_.excess());
  }
  [[nodiscard]] TickDetail detail() const noexcept {
    return {.curve_parameter = interpolator_.curve_parameter(),
            .chord_error_mm = judge_.latest_chord_error_mm(),
            .deviation_mm = interpolator_.deviation_mm(),
            .block = interpolator_.reached_block(),
            .wait_cause = interpolator_.wait_cause(),
            .waits_for_machine = interpolator_.rests_for_machine(),
            .at_rest = interpolator_.is_at_rest()};
  }
  [[nodiscard]] const TickJudge& judge() const noexcept { return judge_; }
  [[nodiscard]] const std::vector<PathControlUse>& path_controls() const noexcept {
    return pipeline_.path().path_controls();
  }
  [[nodiscard]] smoothing::PathDeviation deviation() const noexcept {
    return pipeline_.path().deviations().largest;
  }
  [[nodiscard]] bool has_errors() const { return pipeline_.path().has_errors(); }
  [[nodiscard]] bool left_travel() const noexcept { return pipeline_.path().left_travel(); }
  [[nodiscard]] const std::vector<diagnostics::Diagnostic>& diagnostics() const {
    return pipeline_.path().diagnostics();
  }
  [[nodiscard]] const PlanWaits& waits() const noexcept { return pipeline_.waits_read(); }
  [[nodiscard]] const PlanTotals& totals() const { return pipeline_.totals(); }

 private:
  // A plan that takes over does so so long after it is asked for.
  static constexpr double kMargin_s = 0.01;
  static constexpr int kMaxRefusals = 4;     // after so many the margin does not grow
  static constexpr int kMaxShortenings = 6;  // and after so many the first part stays as it is
  // Of a plan with other feedrates so much is handed over at once.
  static constexpr double kFirstPart_s = 0.1;
  // What the program says at a rest comes so long before it: then the thread that plans tells it
  // before the one that ticks is there, and waits.
  static constexpr double kAnnounced_s = 0.03;
  // Of the horizon: less than this is not worth a stop ahead of its own while there is as much.
  static constexpr std::int64_t kPartsOfHorizon = 8;
  // Of blocks, which take as long as the search over them.
  static constexpr int kManyTaken = 10;

  // M48 to M53 of a line without motion are in force though no tick has had them.
  [[nodiscard]] static Outputs outputs_at_begin(const KernelOptions& options);
  // How far the ticks are on the plan. All that is planned and goes by them looks here first: right
  // before it reads what else the tick side says, and before it changes what that sees.
  [[nodiscard]] std::int64_t now() const {
    std::int64_t tick = interpolator_.plan_tick();
    if (plan_clock_) {
      calls_.follow(plan_clock_, [&] { tick = interpolator_.plan_tick(); });
    }
    return tick;
  }
  // Nothing that was read is left to be run.
  [[nodiscard]] bool has_run_all() const noexcept;
  // The tool is at the program's end, and nobody ended it earlier.
  [[nodiscard]] bool has_come_to_end() const noexcept;
  // To where the tool is.
  void follow_tool();
  bool announces_now();
  // Ticks that were run, as far as it is known on which plan.
  void forget_before(std::int64_t tick);
  [[nodiscard]] double feed_share() const noexcept;

  // True: more text is needed.
  bool fill_queue();

  // Of the horizon: a caller that goes by runs_low() comes again in time.
  [[nodiscard]] bool is_nearly_half_ahead() const;

  // What is in the queue, to the tick side.
  void hand_over();
  // What was just planned, before the end of plan(), where no way to rest is kept after it.
  void hand_on();

  // With a way to rest from there or near it, if there is one.
  void commit_up_to(std::int64_t until);
  // Not done: there is no way to rest from the tick on, or no room for its path yet, of which so
  // many ticks less would do.
  struct StopCommit {
    bool done = false;
    std::int64_t too_late_ticks = 0;
  };
  StopCommit commit_with_stop(std::int64_t tick);
  [[nodiscard]] std::int64_t too_late_ticks(
      const lookahead::Planner::PlannedStopAhead& ahead) const;

  void commit();

  // Where the tick side has taken the stop ahead, the plan goes on from its rest. False: it is just
  // taking it.
  bool follow_stop_ahead();

  // The machine has answered what the program asked.
  void follow_machine(const interp::InquiryAnswer& answer);
  // At feed 0 the tool holds though nobody asked for it, and goes on by itself.
  [[nodiscard]] bool is_at_feed_0() const noexcept;
  void try_hold_feed();
  // To the plan: what does not begin to move.
  void stop_feed();
  void override_spindle_by(double share);
  // From a hold or a wait.
  void go_on();
  [[nodiscard]] TickStatus status_at_wait() const noexcept;
  [[nodiscard]] bool rests_behind_wait(TickStatus status) const noexcept;
  // The plan rests at a wait, which is for after the hold.
  [[nodiscard]] bool holds_at_wait() const noexcept;
  // What was asked for and could not be done yet: the tick side has not answered, or no way to rest
  // was found.
  void follow_commands();
  // The tick side took the plan that was to take over, or refused it.
  void settle(bool accepted);
  // The tick at which a plan takes over that is made now.
  [[nodiscard]] std::int64_t takeover_tick() const;
  // Of a plan that rests, made now.
  [[nodiscard]] lookahead::StopOrder stop_order() const;

  // A plan that takes over. False: it did not fit, and is dropped.
  bool hand_over(lookahead::Outbox&& plan, std::uint32_t from,
                 const lookahead::Planner::PlannedStopAhead* ahead = nullptr);
  void follow_resume();
  [[nodiscard]] bool is_at_hold() const;
  bool try_hold();
  [[nodiscard]] bool has_room_to_hold();
  // A plan that comes to rest. False: it did not fit.
  bool hand_over_hold(lookahead::Outbox&& plan, std::uint32_t from);
  bool try_change_plan();

  void fail_with_check() {
    plan_fault_ = pipeline_.check().fault().has_value();
    broken_ = pipeline_.check().is_broken();
  }

  bool tells_;
  ProgramNotes notes_;
  double period_s_;
  Pipeline pipeline_;
  interp::MotionQueue queue_;
  interp::Interpolator interpolator_;
  TickJudge judge_;
  std::optional<PlaceOfTool> end_;  // written before the last phase is delivered, read after it
  std::atomic<bool> judges_end_ = true;           // a stop does not reach it
  std::atomic<bool> wrong_ = false;               // the program has an error; the same
  std::atomic<bool> plan_fault_ = false;          // a promise of the plan does not hold
  std::atomic<bool> broken_ = false;              // nothing more is planned
  std::atomic<std::uint32_t> answered_wait_ = 0;  // Phase::wait
  std::atomic<std::uint32_t> held_wait_ = 0;      // it is for after the hold
  std::int64_t horizon_ticks_;
  std::int64_t margin_ticks_;
  std::int64_t first_part_ticks_;
  std::int64_t announced_ticks_;
  bool keeps_stop_;
  std::int64_t committed_until_tick_ = 0;
  std::int64_t next_commit_tick_ = 0;  // at the earliest: the queue was full
  // The latest that was committed.
  std::optional<lookahead::Planner::PlannedStopAhead> stop_ahead_{};
  Overrides overrides_{};
  lookahead::StoppedFeed stopped_feed_{};  // by those, and by the inputs
  double feed_ = 1.0;                      // the latest override above 0
  double adaptive_ = 1.0;                  // the latest of the inputs above 0
  bool asks_ = false;                      // the program asks the machine, which has not answered
  bool single_block_ = false;
  bool holds_ = false;        // the operator asked for it; a feed override of 0 is not among this
  bool stops_ = false;        // each hold is a stop
  bool has_stopped_ = false;  // what is planned ends the program: no other stop comes
  bool rests_for_text_ = false;  // the plan ends at rest after all that was read
  bool wants_hold_ = false;
  bool wants_resume_ = false;
  bool wants_change_ = false;
  // A plan that is to take over: the tick side has not answered yet.
  struct PendingTakeover {
    std::uint32_t plan = 0;
    bool changes_plan = false;
    bool ends_program = false;
    std::int64_t committed_before = 0;
    std::optional<lookahead::Planner::PlannedStopAhead> stop{};
  };
  std::optional<PendingTakeover> takeover_{};
  // For what no way was found, of a hold and of a change of feed.
  std::int64_t next_hold_tick_ = 0;
  std::int64_t next_try_tick_ = 0;
  int refusals_ = 0;     // in a row: planning took longer than the margin
  int shortenings_ = 0;  // in a row: the first part of a plan did not fit, and is half as long then
  ProgramState begins_with_;
  std::function<bool(std::int64_t)> plan_clock_;  // KernelOptions
  interp::TickCalls calls_;
  Delivery delivery_{queue_, [this] { static_cast<void>(now()); }};
};

}  // namespace kerf
