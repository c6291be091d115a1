// From a program's text to its plan: reader, smoothing, blocks and look-ahead, wired once.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "interp/inquiry_watch.hpp"
#include "kernel/block_source.hpp"
#include "kernel/plan_check.hpp"
#include "lookahead/planner.hpp"

namespace kerf {

// Every plan is made here: by the kernel that runs it, for the estimate of its time and for the
// explanation of a line, so all three plan the same path. PlanCheck checks the plan against the
// program's blocks. For one thread.
class Pipeline {
 public:
  struct Order {
    const MachineSettings& settings;
    const KernelOptions& options;
    double longest_phase_s = lookahead::PlannerSettings{}.longest_phase_s;
    ProgramPath::Order path{};
    bool may_hold = false;  // PlannerSettings::may_hold
  };
  enum class Step : unsigned char {
    planned,     // something is in the outbox
    took,        // took something from the program; nothing planned yet
    wants_text,  // feed() or finish() must come first
    ended,       // the program is planned to its end, or to where it was stopped
    held,        // nothing more is planned until resume() or settle()
  };

  explicit Pipeline(const Order& order);

  void feed(std::string_view text) { program().feed(text); }
  void finish() { program().finish(); }
  // With KernelOptions::reads_apart, by the thread that feeds.
  ReadStatus read() { return source_.read(); }
  // Runs nothing, for a reason that is not in the text.
  void refuse(diagnostics::Diagnostic fault) { program().refuse(std::move(fault)); }

  // Of text that is not read yet.
  void set_optional_stop(bool on) {
    program().set_optional_stop(on);
    planner_.set_optional_stop(on);
  }
  void keep_blocks_apart(bool on) noexcept { program().keep_blocks_apart(on); }
  void set_tool(const Tool& tool) { program().set_tool(tool); }
  void set_block_delete(const BlockDelete& switches) { program().set_block_delete(switches); }

  // One step. Precondition: no phase is left in the outbox; pieces and line changes may wait there.
  Step step(lookahead::Outbox& outbox);

  // Releases what waits for its successor, as if none came.
  void flush() { program().flush(); }
  // The plan comes to rest after what was read so far; more text continues it.
  void plan_to_rest() { planner_.plan_to_rest(); }
  // Planner::hold, into an outbox that is empty.
  bool hold(const lookahead::StopOrder& order, lookahead::Outbox& outbox);
  // Planner's.
  void stop_feed(const lookahead::StoppedFeed& stopped) noexcept { planner_.stop_feed(stopped); }
  [[nodiscard]] bool is_held_by_feed() const noexcept { return planner_.is_held_by_feed(); }
  [[nodiscard]] bool feed_lets_go() const noexcept { return planner_.feed_lets_go(); }
  bool hold_feed(const lookahead::StopOrder& order, lookahead::Outbox& outbox);
  // Planner::change_plan, into an outbox that is empty.
  std::optional<lookahead::Planner::ChangedPlan> change_plan(
      const lookahead::Planner::PlanChange& change, lookahead::Outbox& outbox);
  void cut_plan_before() { planner_.cut_plan_before(); }
  void settle(bool accepted) {
    check_.settle(accepted);
    planner_.settle(accepted);
  }
  void resume() { planner_.resume(); }
  // Planner::stop_ahead.
  std::optional<lookahead::Planner::PlannedStopAhead> stop_ahead(std::int64_t tick) {
    return planner_.stop_ahead(tick);
  }
  void follow_stop_ahead(const lookahead::Planner::PlannedStopAhead& taken);
  // What was emitted ends at rest.
  [[nodiscard]] bool ends_at_rest() const { return planner_.ends_at_rest(); }
  // Of what is being emitted.
  [[nodiscard]] std::uint32_t plan() const noexcept { return planner_.plan(); }
  // What the program asks the machine, once; before its motion is planned.
  [[nodiscard]] std::optional<interp::Inquiry> take_inquiry();
  // The machine has answered it.
  void follow(const interp::InquiryAnswer& answer);
  // Planner::stop; the rest of the program is dropped.
  bool stop(const lookahead::StopOrder& order, lookahead::Outbox& outbox);
  void stop_held();
  [[nodiscard]] bool wants_block() const noexcept { return planner_.wants_block(); }
  [[nodiscard]] bool is_held() const noexcept { return planner_.is_held(); }
  [[nodiscard]] bool waits() const noexcept { return planner_.waits(); }
  [[nodiscard]] bool waits_for_resume() const noexcept { return planner_.waits_for_resume(); }
  [[nodiscard]] std::uint32_t wait() const noexcept { return planner_.wait(); }
  [[nodiscard]] bool awaits_answer() const noexcept { return planner_.awaits_answer(); }
  [[nodiscard]] std::int64_t emitted_until_tick() const noexcept {
    return planner_.emitted_until_tick();
  }
  [[nodiscard]] std::uint64_t rest_block_at(std::int64_t tick) const {
    return planner_.rest_block_at(tick);
  }
  // The ticks before this one have been run.
  void forget_before(std::int64_t tick);

  // The whole program was read and goes to the plan, or it was stopped.
  [[nodiscard]] bool is_finished() const noexcept { return finished_; }
  [[nodiscard]] const ProgramPath& path() const noexcept { return source_.path(); }
  [[nodiscard]] const PlanTotals& totals() const noexcept { return planner_.totals(); }
  [[nodiscard]] const PlanWaits& waits_read() const noexcept { return planner_.waits_pushed(); }
  [[nodiscard]] const PlanCheck& check() const noexcept { return check_; }
  // The whole program was read, but its end was never planned.
  void fail_without_plan(std::uint32_t line);

 private:
  [[nodiscard]] ProgramPath& program() noexcept { return source_.path(); }
  bool took_over(bool found, const lookahead::Outbox& outbox);
  // Takes the next item of the program into the window. False: there is no more text.
  bool take_next();
  void push_block(BlockItem item);
  void push_rest(const parser::Move& pause);
  void note_question(const parser::Move& pause);

  PipelineObserver* observer_;
  lookahead::Planner planner_;
  BlockSource source_;
  PlanCheck check_;
  double period_s_;
  interp::Inquiry inquiry_{};
  enum class Asking : unsigned char { nothing, motion_follows, ready, asked };
  Asking asking_ = Asking::nothing;
  bool finished_ = false;
};

}  // namespace kerf
