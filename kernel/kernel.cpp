#include "kernel/kernel.hpp"

#include <atomic>
#include <cmath>
#include <string>
#include <utility>

#include "kernel/delivery.hpp"
#include "kernel/machine_file.hpp"
#include "kernel/program_path.hpp"
#include "kernel/settings_check.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/push.hpp"
#include "parser/errors/machine.hpp"

namespace kerf {

using interp::MotionQueue;
using parser::Diagnostic;
using smoothing::PathPart;

class Kernel::Impl {
 public:
  Impl(const MachineSettings& settings, const KernelOptions& options)
      : limits_(settings.limits),
        path_(settings, options),
        planner_({.limits = settings.limits,
                  .profile = options.profile,
                  .window_blocks = options.window_blocks}),
        interpolator_(queue_, settings.limits.period_s, options.start_mm,
                      options.start_extra_rad_mm),
        judge_({.limits = settings.limits,
                .binds_jerk = options.profile.kind() != profiles::ProfileKind::trapezoid,
                .has_extra_axes = settings.program.extra_axes != 0}),
        horizon_ticks_(
            static_cast<std::int64_t>(std::ceil(options.horizon_s / settings.limits.period_s))) {}

  void feed(std::string_view text) { path_.feed(text); }
  void finish() { path_.finish(); }
  void refuse(Diagnostic fault) { path_.refuse(std::move(fault)); }

  bool plan() {
    while (!failed_ && delivery_.deliver(interpolator_.plan_tick() + horizon_ticks_)) {
      if (planner_.emit(delivery_.outbox())) {
        check_.emitted(delivery_.outbox());
        fail_with_check();
        continue;
      }
      if (finished_) {
        return false;
      }
      if (!take_next()) {
        return true;
      }
    }
    return false;
  }

  interp::TickStatus tick(interp::Setpoint& setpoint) noexcept {
    const interp::TickStatus status = interpolator_.next(setpoint);
    if (status == interp::TickStatus::starved) {
      judge_.starve();
    }
    judge_.add(setpoint, interpolator_.chord_error_mm());
    if (status == interp::TickStatus::finished && end_) {
      judge_.judge_end(setpoint, *end_);
    }
    return status == interp::TickStatus::starved && failed_ ? interp::TickStatus::finished : status;
  }

  void reach_tick() {
    while (interpolator_.pass_what_is_over()) {
      plan();
      if (queue_.next_phase() == nullptr) {
        return;  // no more is planned
      }
    }
  }

  interp::TickStatus next(interp::Setpoint& setpoint) {
    if (runs_low() && plan() && runs_low()) {
      drain();
    }
    reach_tick();
    const interp::TickStatus status = tick(setpoint);
    // There is one thread: what is not planned now never is.
    if (status == interp::TickStatus::starved && finished_) {
      check_.fail(setpoint.line, "the program is read and nothing is planned");
      fail_with_check();
    }
    return status;
  }

  [[nodiscard]] bool runs_low() const noexcept {
    return delivery_.frozen_until_tick() - interpolator_.plan_tick() <= horizon_ticks_ / 2;
  }

  void drain() {
    if (!finished_) {
      path_.flush();
      if (plan()) {
        planner_.drain();
        plan();
      }
    }
  }

  void stop() {
    if (!check_.has_ended()) {
      end_.reset();  // not reached any more
    }
    check_.stop();
    planner_.stop();
    finished_ = true;
  }

  [[nodiscard]] std::optional<RunFault> fault() const {
    return check_.fault() ? check_.fault() : describe(judge_.excess());
  }
  [[nodiscard]] const TickJudge& judge() const noexcept { return judge_; }
  [[nodiscard]] smoothing::Departure departure() const noexcept {
    return path_.departures().largest;
  }
  [[nodiscard]] bool has_errors() const { return path_.has_errors(); }
  [[nodiscard]] bool left_travel() const noexcept { return path_.left_travel(); }
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const { return path_.diagnostics(); }
  [[nodiscard]] const lookahead::PlanTotals& totals() const { return planner_.totals(); }

 private:
  // What is next of the program into the window. False: there is no more text.
  bool take_next() {
    ProgramPath::Output output;
    switch (path_.next(output)) {
      case ProgramPath::Next::wants_text:
        return false;
      case ProgramPath::Next::ended:
        end_ = path_.programmed_end();
        check_.judge(path_.departures().worst);
        planner_.finish(path_.line());
        finished_ = true;
        return true;
      case ProgramPath::Next::output:
        break;
    }
    if (auto* part = std::get_if<PathPart>(&output)) {
      push_part(std::move(*part));
    } else {
      lookahead::push_pause(std::get<parser::Move>(output), planner_);
    }
    return true;
  }

  void push_part(PathPart part) {
    const parser::SourcePosition source = part.source;
    const std::vector<parser::EventMove> changes = part.changes;
    auto block = lookahead::block_of(std::move(part), limits_, planner_.scan_for());
    if (!block) {
      path_.cut(source, block.error(), parser::errors::kCurveRefused);
      return;
    }
    check_.pushed(*block);
    lookahead::push_block(std::move(*block), changes, planner_);
  }

  void fail_with_check() { failed_ = check_.is_broken(); }

  lookahead::PlanLimits limits_;
  ProgramPath path_;
  lookahead::Planner planner_;
  MotionQueue queue_;
  interp::Interpolator interpolator_;
  PlanCheck check_;
  TickJudge judge_;
  std::optional<PlaceOfTool> end_;    // written before the last phase is delivered, read after it
  std::atomic<bool> failed_ = false;  // nothing more is planned
  std::int64_t horizon_ticks_;
  Delivery delivery_{queue_};
  bool finished_ = false;
};

Kernel::Kernel(const MachineSettings& settings, const KernelOptions& options) {
  if (auto fault = settings_fault(settings, options)) {
    impl_ = std::make_unique<Impl>(default_machine(), resting_options(options));
    impl_->refuse(std::move(*fault));
  } else {
    impl_ = std::make_unique<Impl>(settings, options);
  }
}
Kernel::~Kernel() = default;
Kernel::Kernel(Kernel&&) noexcept = default;
Kernel& Kernel::operator=(Kernel&&) noexcept = default;

void Kernel::feed(std::string_view text) {
  impl_->feed(text);
}
void Kernel::finish() {
  impl_->finish();
}
bool Kernel::plan() {
  return impl_->plan();
}
interp::TickStatus Kernel::tick(interp::Setpoint& setpoint) noexcept {
  return impl_->tick(setpoint);
}

interp::TickStatus Kernel::next(interp::Setpoint& setpoint) {
  return impl_->next(setpoint);
}

void Kernel::reach_tick() {
  impl_->reach_tick();
}
void Kernel::drain() {
  impl_->drain();
}
bool Kernel::runs_low() const noexcept {
  return impl_->runs_low();
}
void Kernel::stop() {
  impl_->stop();
}
double Kernel::chord_error_mm() const noexcept {
  return impl_->judge().latest_chord_error_mm();
}
std::optional<RunFault> Kernel::fault() const {
  return impl_->fault();
}
const TickJudge& Kernel::judge() const noexcept {
  return impl_->judge();
}
smoothing::Departure Kernel::departure() const noexcept {
  return impl_->departure();
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
const lookahead::PlanTotals& Kernel::totals() const {
  return impl_->totals();
}

}  // namespace kerf
