#include "programs/kerf/io/interrupt.hpp"

#include <atomic>
#include <csignal>
#include <unistd.h>

#include "programs/kerf/io/keyboard.hpp"

namespace kerf::program {

namespace {

// A handler can reach nothing but what is global.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<int> first_signal{0};
std::atomic<bool> expects_emergency_stop{false};
std::atomic<bool> emergency{false};
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)
static_assert(std::atomic<int>::is_always_lock_free, "or the handler may not touch it");

ExitStatus status_of(int signal) noexcept {
  switch (signal) {
    case SIGTERM:
      return ExitStatus::terminated;
    case SIGHUP:
      return ExitStatus::hung_up;
    default:
      return ExitStatus::interrupted;
  }
}

void on_signal(int signal) {
  int none = 0;
  if (first_signal.compare_exchange_strong(none, signal)) {
    return;
  }
  if (!expects_emergency_stop || emergency.exchange(true)) {
    Keyboard::restore();
    _exit(to_int(status_of(signal)));
  }
}

// As nohup leaves it: who starts a run so wants it to go on without its terminal.
bool hang_up_is_ignored() noexcept {
  struct sigaction found {};
  return sigaction(SIGHUP, nullptr, &found) == 0 && found.sa_handler == SIG_IGN;
}

}  // namespace

void install_signal_handlers() {
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  action.sa_handler = on_signal;  // without SA_RESTART: a read that waits for a person must end
  for (const int signal : {SIGINT, SIGQUIT, SIGTERM}) {
    sigaction(signal, &action, nullptr);
  }
  if (!hang_up_is_ignored()) {
    sigaction(SIGHUP, &action, nullptr);
  }
  action.sa_handler = SIG_IGN;
  for (const int signal : {SIGPIPE, SIGXFSZ}) {
    sigaction(signal, &action, nullptr);
  }
}

void expect_emergency_stop() noexcept {
  expects_emergency_stop = true;
}

bool emergency_stop_requested() noexcept {
  return emergency.load(std::memory_order_relaxed);
}

std::optional<ExitStatus> stop_requested() noexcept {
  const int signal = first_signal.load(std::memory_order_relaxed);
  return signal != 0 ? std::optional(status_of(signal)) : std::nullopt;
}

}  // namespace kerf::program
