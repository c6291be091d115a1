#include "programs/kerf/driver/loopback_machine.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <utility>

#include <spdlog/fmt/fmt.h>

namespace kerf::program {

using machine::AxisPlaces;
using machine::AxisState;
using machine::DriveFault;
using machine::MachineState;

namespace {

constexpr int kAnswersATick = 16;

// But for the axes' places.
bool is_finite(const MachineState& state) noexcept {
  const auto all = [](const auto& values) {
    return std::all_of(values.begin(), values.end(),
                       [](double value) { return std::isfinite(value); });
  };
  return std::isfinite(state.contour_error_mm) && all(state.following_error_mm) &&
         all(state.inputs.analog) && (!state.has_latched || all(state.latched_mm)) &&
         std::isfinite(state.outputs.spindle_rad_s) &&
         std::isfinite(state.outputs.spindle_angle_rad) && all(state.outputs.analog);
}

}  // namespace

void LoopbackMachine::Pending::add(const Told& told) noexcept {
  told_[(first_ + count_) % told_.size()] = told;
  ++count_;
}

std::optional<LoopbackMachine::Told> LoopbackMachine::Pending::answer(std::int64_t tick) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    Told told = told_[(first_ + i) % told_.size()];
    if (told.tick == tick) {
      told.is_forgotten = i < forgotten_;
      first_ = (first_ + i + 1) % told_.size();
      count_ -= i + 1;
      forgotten_ -= std::min(forgotten_, i + 1);
      return told;
    }
  }
  return std::nullopt;
}

tl::expected<std::unique_ptr<LoopbackMachine>, std::string> LoopbackMachine::open(
    const Order& order) {
  if (order.timeout_s > kMaxPeriods * order.table.period_s) {
    return tl::unexpected(fmt::format("a time-out of {} s is more than {} periods of {} s",
                                      order.timeout_s, kMaxPeriods, order.table.period_s));
  }
  auto socket = FrameSocket::open(order.socket, std::max(1.0, order.timeout_s));
  if (!socket) {
    return tl::unexpected(socket.error());
  }
  return std::unique_ptr<LoopbackMachine>(new LoopbackMachine(*std::move(socket), order));
}

LoopbackMachine::LoopbackMachine(FrameSocket socket, const Order& order) noexcept
    : socket_(std::move(socket)),
      gate_(order.table),
      timeout_periods_(static_cast<std::size_t>(
          std::max(2.0, std::ceil(order.timeout_s / order.table.period_s - 1e-9)))) {
  for (std::size_t axis = 0; axis < max_following_error_mm_.size(); ++axis) {
    max_following_error_mm_[axis] = order.table.axes[axis].max_following_error_mm;
  }
  if (const machine::MachineState& first = socket_.greeting().state; is_finite(first)) {
    state_.inputs = first.inputs;
  }
}

void LoopbackMachine::enable(const AxisPlaces& places) noexcept {
  if (is_over_) {
    return;
  }
  state_.fault = DriveFault::none;
  if (const auto refusal = machine::SetpointGate::refusal(places)) {
    stop(*refusal);
    return;
  }
  pending_.forget();
  state_ = {.actual_mm = places.mm, .extra_rad_mm = places.extra_rad_mm, .inputs = state_.inputs};
  state_.axes.fill(AxisState::on);
  tell(told_places(places));
}

void LoopbackMachine::disable() noexcept {
  if (state_.fault == DriveFault::none) {
    stop({.why = DriveFault::not_enabled});
  } else if (follows()) {
    stop({.why = state_.fault, .axis = state_.fault_axis});
  } else if (!is_disabled_) {  // a fault of the machine's own: its axes stop or are off
    tell({.call = MachineCall::disable});
  }
}

void LoopbackMachine::write(const Setpoint& setpoint) noexcept {
  take_answers();
  judge_delay();
  if (is_over_) {
    return;
  }
  const auto refusal = gate_.refusal(setpoint);
  if (!refusal) {
    tell({.setpoint = setpoint});
  } else if (follows()) {
    stop(*refusal);
  }
}

void LoopbackMachine::tell(const ToldFrame& told) noexcept {
  if (is_over_) {
    return;
  }
  is_disabled_ = told.call == MachineCall::disable;
  if (pending_.is_full()) {
    hang_up(DriveFault::no_answer);
  } else if (socket_.send(told)) {
    Told pending{.tick = told.setpoint.tick, .is_setpoint = told.call == MachineCall::write};
    if (told.call != MachineCall::disable) {
      pending.place_mm = told.setpoint.position_mm;
    }
    pending_.add(pending);
  } else {
    hang_up(errno == EAGAIN ? DriveFault::no_answer : DriveFault::connection_lost);
  }
}

void LoopbackMachine::take_answers() noexcept {
  for (int i = 0; i < kAnswersATick && !is_over_; ++i) {
    const FrameSocket::Received received = socket_.receive();
    if (received.what == FrameSocket::Received::What::nothing) {
      return;
    }
    if (received.what == FrameSocket::Received::What::hung_up) {
      hang_up(DriveFault::connection_lost);
      return;
    }
    const auto told = received.answer ? pending_.answer(received.answer->tick) : std::nullopt;
    if (!told) {
      note(DriveFault::bad_answer);
    } else if (!told->is_forgotten) {
      answered_tick_ = told->tick;
      take(received.answer->state);
      judge_place(*told);
    }
  }
}

void LoopbackMachine::take(const MachineState& answer) noexcept {
  if (const auto refusal = machine::SetpointGate::refusal(
          AxisPlaces{.mm = answer.actual_mm, .extra_rad_mm = answer.extra_rad_mm})) {
    stop(*refusal);
    return;
  }
  if (!is_finite(answer)) {
    note(DriveFault::bad_answer);
    return;
  }
  const DriveFault fault = state_.fault;
  const std::int8_t axis = state_.fault_axis;
  state_ = answer;
  if (fault != DriveFault::none) {  // the first one stays
    state_.fault = fault;
    state_.fault_axis = axis;
  }
}

void LoopbackMachine::judge_place(const Told& told) noexcept {
  for (std::size_t axis = 0; axis < max_following_error_mm_.size() && told.is_setpoint; ++axis) {
    if (state_.fault == DriveFault::none && state_.axes[axis] != AxisState::on) {
      stop({.why = DriveFault::drive_tripped, .axis = static_cast<std::int8_t>(axis)});
    }
  }
  for (std::size_t axis = 0; axis < max_following_error_mm_.size() && told.place_mm; ++axis) {
    const double error_mm = (*told.place_mm)[axis] - state_.actual_mm[axis];
    if (follows() && !(std::abs(error_mm) <= max_following_error_mm_[axis])) {
      stop({.why = DriveFault::following_error, .axis = static_cast<std::int8_t>(axis)});
    }
  }
}

void LoopbackMachine::judge_delay() noexcept {
  if (pending_.count() > timeout_periods_) {
    note(DriveFault::no_answer);
  }
  if (pending_.count() > 2 * timeout_periods_) {
    hang_up(DriveFault::no_answer);
  }
}

void LoopbackMachine::note(DriveFault fault) noexcept {
  if (state_.fault == DriveFault::none) {
    state_.fault = fault;
    state_.fault_axis = -1;
  }
}

void LoopbackMachine::stop(machine::SetpointGate::Refusal why) noexcept {
  if (state_.fault == DriveFault::none) {
    state_.fault = why.why;
    state_.fault_axis = why.axis;
  }
  state_.axes.fill(AxisState::stopping);
  interp::apply({.kind = interp::OutputChangeKind::all_off}, state_.outputs);
  pending_.forget();
  tell({.call = MachineCall::disable});
}

void LoopbackMachine::hang_up(DriveFault fault) noexcept {
  if (state_.fault == DriveFault::none || state_.fault == DriveFault::not_enabled) {
    state_.fault = fault;
    state_.fault_axis = -1;
  }
  state_.axes.fill(AxisState::off);
  interp::apply({.kind = interp::OutputChangeKind::all_off}, state_.outputs);
  // Where it still hears, it is to be off; whether it does makes no difference here.
  static_cast<void>(socket_.send({.call = MachineCall::disable}));
  socket_.hang_up();
  is_over_ = true;
}

bool LoopbackMachine::follows() const noexcept {
  return std::find(state_.axes.begin(), state_.axes.end(), AxisState::on) != state_.axes.end();
}

}  // namespace kerf::program
