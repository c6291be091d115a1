#include "kernel/kernel.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "kernel/blend_settings.hpp"
#include "kernel/delivery.hpp"
#include "kernel/reader_options.hpp"
#include "lookahead/block_builder.hpp"
#include "lookahead/switches.hpp"
#include "machine/envelope.hpp"
#include "parser/errors/machine.hpp"
#include "parser/program_reader.hpp"
#include "smoothing/smoother.hpp"

namespace kerf {

using interp::MotionQueue;
using parser::Diagnostic;
using parser::Move;
using smoothing::PathPart;
using Output = smoothing::Smoother::Output;

class Kernel::Impl {
 public:
  Impl(const MachineSettings& settings, const KernelOptions& options)
      : limits_(settings.limits),
        envelope_(machine::envelope_of(settings.table)),
        extra_envelope_(settings.table.extra),
        checks_travel_(options.checks_travel),
        reader_(reader_options(settings, options)),
        smoother_(blend_settings(settings)),
        planner_({.limits = settings.limits,
                  .profile = options.profile,
                  .window_blocks = options.window_blocks}),
        interpolator_(queue_, settings.limits.period_s, options.start_mm,
                      options.start_extra_rad_mm),
        horizon_ticks_(
            static_cast<std::int64_t>(std::ceil(options.horizon_s / settings.limits.period_s))) {}

  void feed(std::string_view text) { reader_.feed(text); }
  void finish() { reader_.finish(); }

  bool plan() {
    while (delivery_.deliver(interpolator_.plan_tick() + horizon_ticks_)) {
      if (planner_.emit(delivery_.outbox())) {
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
    return interpolator_.next(setpoint);
  }

  [[nodiscard]] bool runs_low() const noexcept {
    return delivery_.frozen_until_tick() - interpolator_.plan_tick() <= horizon_ticks_ / 2;
  }

  void drain() {
    if (!finished_) {
      smoother_.flush();
      if (plan()) {
        planner_.drain();
        plan();
      }
    }
  }

  void stop() {
    planner_.stop();
    finished_ = true;
  }

  [[nodiscard]] double chord_error_mm() const noexcept { return interpolator_.chord_error_mm(); }
  [[nodiscard]] const smoothing::Departure& departure() const noexcept {
    return smoother_.departure();
  }
  [[nodiscard]] bool has_errors() const { return reader_.has_errors() || plan_failed_; }
  [[nodiscard]] bool left_travel() const noexcept { return left_travel_; }
  [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const {
    return plan_failed_ ? all_diagnostics_ : reader_.diagnostics();
  }
  [[nodiscard]] const lookahead::PlanTotals& totals() const { return planner_.totals(); }

 private:
  // What is next of the program into the window. False: there is no more text.
  bool take_next() {
    Output output;
    while (!smoother_.next(output)) {
      if (program_ended_) {
        planner_.finish(line_);
        finished_ = true;
        return true;
      }
      if (!read_move()) {
        return false;
      }
    }
    if (path_cut_) {
      return true;
    }
    if (auto* part = std::get_if<PathPart>(&output)) {
      push_part(std::move(*part));
    } else {
      push_pause(std::get<Move>(output));
    }
    return true;
  }

  // The next move of the program into the smoother. False: there is no more text.
  bool read_move() {
    Move move;
    const bool read = reader_.next(move);
    if (!read && !reader_.has_errors() && !reader_.at_end()) {
      return false;
    }
    if (!read || reader_.has_errors()) {
      end_program();
      return true;
    }
    source_ = move.source;
    line_ = move.source.line;
    if (const auto taken = smoother_.push(move); !taken) {
      fail(taken.error(), parser::errors::kCurveRefused);
    }
    return true;
  }

  void push_pause(const Move& move) {
    if (const auto* dwell = std::get_if<parser::DwellMove>(&move.shape)) {
      planner_.push_rest(dwell->duration_s, move.source.line);
    } else if (const auto* event = std::get_if<parser::EventMove>(&move.shape)) {
      lookahead::push_event(*event, move.source.line, planner_);
    }
  }

  void push_part(PathPart part) {
    if (const char* what = lookahead::unbounded(limits_); what != nullptr) {
      cut_path(part.source, {part.source.line, std::string("the machine has no limit of ") + what},
               parser::errors::kMachineWithoutLimit);
      return;
    }
    const parser::SourcePosition source = part.source;
    const std::vector<parser::EventMove> changes = part.changes;
    auto block = lookahead::block_of(std::move(part), limits_, planner_.scan_steps());
    if (!block) {
      cut_path(source, block.error(), parser::errors::kCurveRefused);
      return;
    }
    if (checks_travel_ && leaves_travel(*block, source)) {
      return;
    }
    for (const parser::EventMove& change : changes) {
      lookahead::push_event(change, block->line, planner_);
    }
    planner_.push(std::move(*block));
  }

  bool leaves_travel(const lookahead::Block& block, const parser::SourcePosition& source) {
    auto excess = machine::outside_travel(extra_envelope_, block.extra.end_rad_mm);
    if (!excess) {
      excess = machine::outside_travel(envelope_, curves::extents(block.curve));
    }
    if (excess) {
      left_travel_ = true;
      cut_path(source, {block.line, machine::describe(*excess)}, parser::errors::kOutsideTravel);
    }
    return excess.has_value();
  }

  // The path ends before this part, and nothing that the smoother still holds is run.
  void cut_path(const parser::SourcePosition& source, const smoothing::PathError& error,
                const parser::ErrorPage& page) {
    path_cut_ = true;
    source_ = source;
    fail(error, page);
  }

  void fail(const smoothing::PathError& error, const parser::ErrorPage& page) {
    plan_failed_ = true;
    all_diagnostics_ = reader_.diagnostics();
    parser::SourcePosition place = source_;
    if (error.line != place.line) {  // inside a curve of many blocks
      place.line = error.line;
      place.column = 1;
    }
    Diagnostic& diagnostic = all_diagnostics_.emplace_back(place, page, error.message);
    diagnostic.file = reader_.file_name(place.file);
    end_program();
  }

  // What is held back still runs.
  void end_program() {
    smoother_.flush();
    program_ended_ = true;
  }

  lookahead::PlanLimits limits_;
  machine::Envelope envelope_;
  machine::ExtraEnvelope extra_envelope_;
  bool checks_travel_;
  parser::ProgramReader reader_;
  smoothing::Smoother smoother_;
  lookahead::Planner planner_;
  MotionQueue queue_;
  interp::Interpolator interpolator_;
  std::int64_t horizon_ticks_;
  Delivery delivery_{queue_};
  parser::SourcePosition source_;  // of the move taken last
  std::uint32_t line_ = 0;
  bool program_ended_ = false;  // what the smoother still holds is all that follows
  bool path_cut_ = false;
  bool finished_ = false;
  bool plan_failed_ = false;
  bool left_travel_ = false;
  std::vector<Diagnostic> all_diagnostics_;
};

Kernel::Kernel(const MachineSettings& settings, const KernelOptions& options)
    : impl_(std::make_unique<Impl>(settings, options)) {}
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
  if (impl_->runs_low() && impl_->plan() && impl_->runs_low()) {
    impl_->drain();
  }
  return impl_->tick(setpoint);
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
  return impl_->chord_error_mm();
}
const smoothing::Departure& Kernel::departure() const noexcept {
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
