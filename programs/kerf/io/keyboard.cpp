#include "programs/kerf/io/keyboard.hpp"

#include <algorithm>
#include <atomic>
#include <poll.h>
#include <string_view>
#include <termios.h>
#include <unistd.h>

namespace kerf::program {

namespace {

// A handler can reach nothing but what is global.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
termios before{};
std::atomic<bool> is_changed = false;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

// Of what a terminal sends for an arrow and the like: Esc, '[' or 'O', parameters, a letter. 0: it
// begins with none. An Esc with anything else after it is the key, pressed.
std::size_t length_of_sequence(std::string_view bytes) noexcept {
  if (bytes.size() < 2 || bytes[0] != '\x1b' || (bytes[1] != '[' && bytes[1] != 'O')) {
    return 0;
  }
  std::size_t end = 2;
  while (end < bytes.size() && bytes[end] >= ' ' && bytes[end] < '@') {
    ++end;
  }
  return std::min(end + 1, bytes.size());
}

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

std::optional<char> Keyboard::next_read() noexcept {
  for (;;) {
    const std::string_view left(read_.data() + next_, count_ - next_);
    if (left.empty()) {
      return std::nullopt;
    }
    const std::size_t sequence = length_of_sequence(left);
    next_ += std::max<std::size_t>(sequence, 1);
    if (sequence == 0) {
      return left.front();
    }
  }
}

std::optional<char> Keyboard::key(std::chrono::milliseconds wait) noexcept {
  if (const auto key = next_read()) {
    return key;
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
  count_ = static_cast<std::size_t>(count);
  return next_read();
}

}  // namespace kerf::program
