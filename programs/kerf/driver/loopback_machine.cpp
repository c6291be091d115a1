#include "programs/kerf/driver/loopback_machine.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <poll.h>
#include <span>
#include <sys/socket.h>
#include <sys/un.h>
#include <utility>

#include <spdlog/fmt/fmt.h>

namespace kerf::program {

using machine::AxisPlaces;
using machine::AxisState;
using machine::DriveFault;
using machine::MachineState;

namespace {

constexpr int kAnswersATick = 16;
constexpr const char* kHangsUp = "the machine hangs up";

// With room for a byte too many, which shows that it is no answer.
using ReceivedBytes = std::array<std::byte, kAnswerBytes + 1>;

bool send_bytes(int socket, const ToldBytes& bytes) noexcept {
  return ::send(socket, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL) ==
         static_cast<ssize_t>(bytes.size());
}

tl::expected<Descriptor, int> connect_to(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    return tl::unexpected(ENAMETOOLONG);
  }
  std::memcpy(static_cast<void*>(address.sun_path), path.data(), path.size());
  Descriptor socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
  // The address is that of a path, which the call takes as one of any family.
  const auto* const any =
      reinterpret_cast<const sockaddr*>(&address);  // NOLINT(*-reinterpret-cast)
  if (!socket.is_open() || ::connect(socket.number(), any, sizeof address) != 0) {
    return tl::unexpected(errno);
  }
  // As much as the system gives: the frames of a time-out and more wait for who is late.
  constexpr int kRoomBytes = 1 << 20;
  static_cast<void>(
      ::setsockopt(socket.number(), SOL_SOCKET, SO_SNDBUF, &kRoomBytes, sizeof kRoomBytes));
  return socket;
}

bool is_finite(const MachineState& state) noexcept {
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto& errors = state.following_error_mm;
  const auto& analog = state.inputs.analog;
  return std::isfinite(state.contour_error_mm) &&
         std::all_of(errors.begin(), errors.end(), finite) &&
         std::all_of(analog.begin(), analog.end(), finite);
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
  auto socket = connect_to(order.socket);
  if (!socket) {
    return tl::unexpected(order.socket + ": " + error_text(socket.error()));
  }
  std::unique_ptr<LoopbackMachine> machine(new LoopbackMachine(*std::move(socket), order));
  if (const auto why = machine->greet(std::max(1.0, order.timeout_s))) {
    return tl::unexpected(order.socket + ": " + *why);
  }
  return machine;
}

LoopbackMachine::LoopbackMachine(Descriptor socket, const Order& order) noexcept
    : socket_(std::move(socket)),
      gate_(order.table),
      timeout_periods_(static_cast<std::size_t>(
          std::max(2.0, std::ceil(order.timeout_s / order.table.period_s - 1e-9)))) {
  for (std::size_t axis = 0; axis < max_following_error_mm_.size(); ++axis) {
    max_following_error_mm_[axis] = order.table.axes[axis].max_following_error_mm;
  }
}

// An answer that is not read when the socket closes is an error (ECONNRESET) at the other end, in
// place of the frames that it has not read yet.
LoopbackMachine::~LoopbackMachine() {
  ::shutdown(socket_.number(), SHUT_RDWR);
  ReceivedBytes bytes{};
  while (::recv(socket_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT) > 0) {
  }
}

std::optional<std::string> LoopbackMachine::greet(double timeout_s) {
  if (!send_bytes(socket_.number(), to_bytes(ToldFrame{.call = MachineCall::disable}))) {
    return errno == EPIPE || errno == ECONNRESET ? kHangsUp : error_text(errno);
  }
  pollfd waits{.fd = socket_.number(), .events = POLLIN, .revents = 0};
  if (::poll(&waits, 1, static_cast<int>(timeout_s * 1e3)) <= 0) {
    return fmt::format("the machine does not answer within {} s", timeout_s);
  }
  ReceivedBytes bytes{};
  const ssize_t count =
      ::recv(socket_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_TRUNC);
  if (count <= 0) {
    return kHangsUp;
  }
  const auto size = static_cast<std::size_t>(count);
  if (!answer_from(std::span(bytes).first(std::min(size, bytes.size())))) {
    return fmt::format("the machine answers {} bytes that are no answer of version {}", size,
                       kFrameVersion);
  }
  return std::nullopt;
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
  state_ = {.actual_mm = places.mm, .extra_rad_mm = places.extra_rad_mm};
  state_.axes.fill(AxisState::on);
  tell(told_places(places));
}

void LoopbackMachine::disable() noexcept {
  if (state_.fault == DriveFault::none) {
    stop({.why = DriveFault::not_enabled});
  } else if (follows()) {
    stop({.why = state_.fault, .axis = state_.fault_axis});
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
  if (pending_.is_full()) {
    hang_up(DriveFault::no_answer);
  } else if (send_bytes(socket_.number(), to_bytes(told))) {
    Told pending{.tick = told.setpoint.tick};
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
    ReceivedBytes bytes{};
    const ssize_t count =
        ::recv(socket_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_TRUNC);
    if (count < 0 && errno == EAGAIN) {
      return;
    }
    if (count <= 0) {
      hang_up(DriveFault::connection_lost);
      return;
    }
    const auto size = std::min(static_cast<std::size_t>(count), bytes.size());
    const auto answer = answer_from(std::span(bytes).first(size));
    const auto told = answer ? pending_.answer(answer->tick) : std::nullopt;
    if (!told) {
      note(DriveFault::bad_answer);
    } else if (!told->is_forgotten) {
      take(answer->state);
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
  static_cast<void>(
      send_bytes(socket_.number(), to_bytes(ToldFrame{.call = MachineCall::disable})));
  ::shutdown(socket_.number(), SHUT_RDWR);
  is_over_ = true;
}

bool LoopbackMachine::follows() const noexcept {
  return std::find(state_.axes.begin(), state_.axes.end(), AxisState::on) != state_.axes.end();
}

}  // namespace kerf::program
