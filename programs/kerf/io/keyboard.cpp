#include "programs/kerf/io/keyboard.hpp"

#include <atomic>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace kerf::program {

namespace {

// A handler can reach nothing but what is global.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
termios before{};
std::atomic<bool> is_changed = false;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

}  // namespace

bool Keyboard::has_terminal() noexcept {
  return ::isatty(STDIN_FILENO) == 1 && ::tcgetpgrp(STDIN_FILENO) == ::getpgrp();
}

Keyboard::Keyboard() noexcept {
  if (!has_terminal() || ::tcgetattr(STDIN_FILENO, &before) != 0) {
    return;
  }
  termios keys = before;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  keys.c_cc[VMIN] = 1;
  keys.c_cc[VTIME] = 0;
  is_changed = true;
  open_ = ::tcsetattr(STDIN_FILENO, TCSANOW, &keys) == 0;
}

Keyboard::~Keyboard() {
  restore();
}

void Keyboard::restore() noexcept {
  if (is_changed.exchange(false)) {
    ::tcsetattr(STDIN_FILENO, TCSANOW, &before);
  }
}

std::optional<char> Keyboard::key(std::chrono::milliseconds wait) noexcept {
  if (next_ < count_) {
    return read_[next_++];
  }
  next_ = count_ = 0;
  pollfd terminal{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  if (::poll(&terminal, 1, static_cast<int>(wait.count())) != 1) {
    return std::nullopt;
  }
  const ssize_t count = ::read(STDIN_FILENO, read_.data(), read_.size());
  if (count <= 0) {  // the terminal is gone
    ::poll(nullptr, 0, static_cast<int>(wait.count()));
    return std::nullopt;
  }
  if (read_.front() == '\x1b' && count > 1) {
    return std::nullopt;
  }
  count_ = static_cast<std::size_t>(count);
  return read_[next_++];
}

}  // namespace kerf::program
