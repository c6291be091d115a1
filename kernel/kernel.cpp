#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "interp/interpolator.hpp"
#include "kernel/delivery.hpp"
#include "kernel/pipeline.hpp"
#include "kernel/settings_check.hpp"
#include "kernel/tick_judge.hpp"

namespace kerf {

using diagnostics::Diagnostic;
using interp::MotionQueue;

class Kernel::Impl {
 public:
  Impl(const MachineSettings& settings, const KernelOptions& options)
      : pipeline_({.settings = settings, .options = options, .may_hold = true}),
        interpolator_(queue_, settings.limits.period_s, options.start_mm,
                      options.start_extra_rad_mm, settings.limits),
        judge_({.limits = settings.limits,
                .binds_jerk = options.profile.kind != profiles::ProfileKind::trapezoid,
                .has_extra_axes = settings.program.extra_axes != 0}),
        horizon_ticks_(
            static_cast<std::int64_t>(std::ceil(options.horizon_s / settings.limits.period_s))),
        margin_ticks_(static_cast<std::int64_t>(std::ceil(kMargin_s / settings.limits.period_s))),
        keeps_stop_(!options.one_thread) {}

  void feed(std::string_view text) { pipeline_.feed(text); }
  void finish() { pipeline_.finish(); }
  void refuse(Diagnostic fault) { pipeline_.refuse(std::move(fault)); }

  bool plan() {
    const std::int64_t now = interpolator_.plan_tick();
    if (!follow_stop_ahead()) {
      return false;
    }
    pipeline_.forget_before(now);
    follow_holds();
    if (keeps_stop_ && !runs_low()) {
      return false;
    }
    const bool wants_text = fill_queue();
    hand_over();
    return wants_text;
  }

  TickStatus tick(Setpoint& setpoint) noexcept {
    const TickStatus status = interpolator_.next(setpoint);
    if (status == TickStatus::starved) {
      judge_.starve();
    }
    if (interpolator_.is_emergency()) {
      return status;  // no promise holds any more
    }
    judge_.add(setpoint, interpolator_.chord_error_mm());
    if (status == TickStatus::finished && end_ && judges_end_) {
      judge_.judge_end(setpoint, *end_);
    }
    const bool ends = status == TickStatus::finished || (status == TickStatus::starved && broken_);
    return !ends ? status : has_fault() || wrong_ ? TickStatus::failed : TickStatus::finished;
  }

  [[nodiscard]] bool has_fault() const noexcept {
    return broken_ || judge_.excess().figure != TickExcess::Figure::none;
  }

  void reach_tick() {
    while (interpolator_.pass_what_is_over()) {
      plan();
      if (queue_.next_phase() == nullptr) {
        return;  // no more is planned
      }
    }
  }

  TickStatus next(Setpoint& setpoint) {
    keeps_stop_ = false;
    const bool is_asked = wants_hold_ || wants_resume_ || takeover_;
    if ((is_asked || runs_low()) && plan() && runs_low()) {
      plan_to_rest();
    }
    reach_tick();
    const TickStatus status = tick(setpoint);
    // There is one thread: what is not planned now never is.
    if (status == TickStatus::starved && pipeline_.is_finished()) {
      pipeline_.fail_without_plan(setpoint.line);
      fail_with_check();
    }
    return status;
  }

  [[nodiscard]] bool runs_low() const noexcept {
    return committed_until_tick_ - interpolator_.plan_tick() <= horizon_ticks_ / 2;
  }

  void plan_to_rest() {
    if (!pipeline_.is_finished()) {
      pipeline_.flush();
      if (plan()) {
        pipeline_.plan_to_rest();
        plan();
      }
    }
  }

  void emergency_stop() noexcept { interpolator_.emergency_stop(); }

  void hold() {
    wants_hold_ = true;
    wants_resume_ = false;
    plan();
  }
  void resume() {
    wants_hold_ = stops_;
    wants_resume_ = true;
    plan();
  }

  void stop() {
    stops_ = true;
    hold();
  }

  [[nodiscard]] std::optional<RunFault> fault() const {
    const std::optional<RunFault>& of_plan = pipeline_.check().fault();
    return of_plan ? of_plan : describe(judge_.excess());
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
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const {
    return pipeline_.path().diagnostics();
  }
  [[nodiscard]] const PlanTotals& totals() const { return pipeline_.totals(); }

 private:
  // A plan that takes over does so so long after it is asked for.
  static constexpr double kMargin_s = 0.01;
  // Of the horizon: less than this is not worth a stop ahead of its own while there is as much.
  static constexpr std::int64_t kPartsOfHorizon = 8;

  // True: more text is needed.
  bool fill_queue() {
    while (!broken_ && delivery_.deliver(interpolator_.plan_tick() + horizon_ticks_)) {
      const bool was_finished = pipeline_.is_finished();
      switch (pipeline_.step(delivery_.outbox())) {
        case Pipeline::Step::planned:
          fail_with_check();
          break;
        case Pipeline::Step::took:
          if (pipeline_.is_finished() && !was_finished) {
            end_ = pipeline_.path().programmed_end();
            wrong_ = pipeline_.path().has_errors();
          }
          break;
        case Pipeline::Step::wants_text:
          return true;
        case Pipeline::Step::ended:
        case Pipeline::Step::held:
          return false;
      }
    }
    return false;
  }

  // What is in the queue, to the tick side.
  void hand_over() {
    const std::int64_t until = delivery_.frozen_until_tick();
    if (!keeps_stop_ || pipeline_.is_held() ||
        (delivery_.outbox().phases.empty() && pipeline_.ends_at_rest())) {
      commit();
      return;
    }
    const std::int64_t now = interpolator_.plan_tick();
    const std::int64_t part = horizon_ticks_ / kPartsOfHorizon;
    const bool is_urgent = committed_until_tick_ - now <= part;
    if (until - committed_until_tick_ < part && !is_urgent) {
      return;
    }
    // Near the end of what is in the queue, or before it where there is no way to rest from there.
    const std::int64_t earliest = std::max(committed_until_tick_ + 1, now + 1);
    for (std::int64_t tick = until - margin_ticks_, step = margin_ticks_;; tick -= step *= 2) {
      if (commit_with_stop(std::max(tick, earliest))) {
        return;
      }
      if (tick <= earliest) {
        break;
      }
    }
    if (is_urgent) {
      commit();
    }
  }

  // False: there is no way to rest from the tick on.
  bool commit_with_stop(std::int64_t tick) {
    auto ahead = pipeline_.stop_ahead(tick);
    if (!ahead) {
      return false;
    }
    const std::int64_t until = ahead->stop.from.when.tick;
    delivery_.deliver(until);
    if (delivery_.commit(*ahead, pipeline_.plan())) {
      committed_until_tick_ = until;
      stop_ahead_ = std::move(ahead);
    }
    return true;
  }

  void commit() {
    if (delivery_.commit()) {
      committed_until_tick_ = delivery_.frozen_until_tick();
    }
  }

  // Where the tick side has taken the stop ahead, the plan goes on from its rest. False: it is just
  // taking it.
  bool follow_stop_ahead() {
    if (!queue_.stop_taken()) {
      return true;
    }
    if (interpolator_.answer().in_force != stop_ahead_->plan) {
      return false;
    }
    if (takeover_) {  // from the plan before: it is refused
      pipeline_.settle(false);
      takeover_.reset();
      wants_hold_ = true;
    }
    pipeline_.follow_stop_ahead(*stop_ahead_);
    delivery_.follow_stop();
    committed_until_tick_ = interpolator_.plan_tick();
    return true;
  }

  // What was asked for and could not be done yet: the tick side has not answered, or no way to rest
  // was found.
  void follow_holds() {
    if (takeover_ && interpolator_.answer().plan == takeover_) {
      pipeline_.settle(interpolator_.answer().in_force == takeover_);
      wants_hold_ = wants_hold_ || interpolator_.answer().in_force != takeover_;
      takeover_.reset();
    }
    if (!takeover_ && wants_resume_ && !wants_hold_) {
      // A wait that the tool has not come to is not answered.
      if (pipeline_.is_held() || interpolator_.plan_tick() >= pipeline_.emitted_until_tick()) {
        pipeline_.resume();
      }
      wants_resume_ = false;
    }
    if (!takeover_ && wants_hold_) {
      wants_hold_ = !try_hold();
    }
  }

  bool try_hold() {
    if (pipeline_.is_held()) {
      if (stops_) {
        judges_end_ = false;
        pipeline_.stop_held();
      }
      return true;
    }
    if (queue_.phases_free() < interp::StopAhead::kPhases + delivery_.outbox().phases.size()) {
      return false;
    }
    const std::int64_t now = interpolator_.plan_tick();
    const std::int64_t last = std::max(pipeline_.emitted_until_tick(), now);
    lookahead::Outbox plan;
    const std::uint32_t from = pipeline_.plan();
    const std::int64_t tick = std::min(now + margin_ticks_, last);
    if (!(stops_ ? pipeline_.stop(tick, plan) : pipeline_.hold(tick, plan))) {
      return false;
    }
    if (!plan.phases.empty()) {
      judges_end_ = !stops_;
      takeover_ = plan.phases.front().plan;
      delivery_.take_over(std::move(plan), from);
      queue_.commit();
      committed_until_tick_ = delivery_.frozen_until_tick();
      fail_with_check();
    }
    return true;
  }

  void fail_with_check() { broken_ = pipeline_.check().is_broken(); }

  Pipeline pipeline_;
  MotionQueue queue_;
  interp::Interpolator interpolator_;
  TickJudge judge_;
  std::optional<PlaceOfTool> end_;  // written before the last phase is delivered, read after it
  std::atomic<bool> judges_end_ = true;  // a stop does not reach it
  std::atomic<bool> wrong_ = false;      // the program has an error; the same
  std::atomic<bool> broken_ = false;     // nothing more is planned
  std::int64_t horizon_ticks_;
  std::int64_t margin_ticks_;
  bool keeps_stop_;
  std::int64_t committed_until_tick_ = 0;
  std::optional<lookahead::Planner::StopAhead> stop_ahead_{};  // the latest that was committed
  bool wants_hold_ = false;
  bool wants_resume_ = false;
  bool stops_ = false;                       // each hold is a stop
  std::optional<std::uint32_t> takeover_{};  // the tick side has not answered yet
  Delivery delivery_{queue_};
};

Kernel::Kernel(const MachineSettings& settings, const KernelOptions& options) {
  if (auto fault = settings_fault(settings, options)) {
    auto resting = std::make_unique<Impl>(default_machine(), resting_options(options));
    resting->refuse(std::move(*fault));
    impl_ = resting.release();
  } else {
    impl_ = std::make_unique<Impl>(settings, options).release();
  }
}
Kernel::~Kernel() {
  delete impl_;
}
Kernel::Kernel(Kernel&& other) noexcept : impl_(std::exchange(other.impl_, nullptr)) {}
Kernel& Kernel::operator=(Kernel&& other) noexcept {
  std::swap(impl_, other.impl_);
  return *this;
}

void Kernel::feed(std::string_view text) {
  impl_->feed(text);
}
void Kernel::finish() {
  impl_->finish();
}
bool Kernel::plan() {
  return impl_->plan();
}
TickStatus Kernel::tick(Setpoint& setpoint) noexcept {
  return impl_->tick(setpoint);
}

TickStatus Kernel::next(Setpoint& setpoint) {
  return impl_->next(setpoint);
}

void Kernel::reach_tick() {
  impl_->reach_tick();
}
void Kernel::plan_to_rest() {
  impl_->plan_to_rest();
}
bool Kernel::runs_low() const noexcept {
  return impl_->runs_low();
}
void Kernel::stop() {
  impl_->stop();
}
void Kernel::emergency_stop() noexcept {
  impl_->emergency_stop();
}
void Kernel::hold() {
  impl_->hold();
}
void Kernel::resume() {
  impl_->resume();
}
double Kernel::chord_error_mm() const noexcept {
  return impl_->judge().latest_chord_error_mm();
}
std::optional<RunFault> Kernel::fault() const {
  return impl_->fault();
}
bool Kernel::has_fault() const noexcept {
  return impl_->has_fault();
}
RunFigures Kernel::figures() const noexcept {
  const TickJudge& judge = impl_->judge();
  return {.path = judge.path(),
          .axes = judge.axes(),
          .extra = judge.extra_axes(),
          .chord_error_mm = judge.chord_error_mm()};
}
std::vector<PathControlUse> Kernel::path_controls() const {
  return impl_->path_controls();
}

smoothing::PathDeviation Kernel::deviation() const noexcept {
  return impl_->deviation();
}
bool Kernel::left_travel() const noexcept {
  return impl_->left_travel();
}
bool Kernel::has_errors() const {
  return impl_->has_errors();
}
const std::vector<Diagnostic>& Kernel::diagnostics() const {
  return impl_->diagnostics();
}
const PlanTotals& Kernel::totals() const {
  return impl_->totals();
}

}  // namespace kerf
