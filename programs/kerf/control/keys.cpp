#include "programs/kerf/control/keys.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>
#include <unistd.h>

#include "programs/kerf/io/descriptor.hpp"
#include "programs/kerf/io/progress_bar.hpp"

namespace kerf::program {

namespace {

using Asked = kerf::Command;

constexpr char kEscape = '\x1b';
constexpr std::chrono::milliseconds kWait{50};
constexpr int kFeedStep_percent = 10;
constexpr double kStep_mm = 1.0;
constexpr int kMaxFeed_percent = 200;

int feed_percent(const ControllerStatus& status) {
  return static_cast<int>(std::lround(100.0 * status.overrides.feed));
}

}  // namespace

Keys::Keys(Operator& by) : by_(&by) {
  if (keyboard_.is_open()) {
    thread_ = std::thread([this] { read(); });
  }
}

Keys::~Keys() {
  over_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
  by_->drop_orders(this);
}

void Keys::read() {
  while (!over_) {
    const auto key = keyboard_.key(kWait);
    if (key == kEscape) {
      by_->emergency_stop();
    } else if (key) {
      by_->ask(this, [this, key] { press(*key); });
    }
    write_refusal();
  }
}

void Keys::give(const OperatorOrder& order) {
  const auto given = by_->give(order);
  const std::lock_guard lock(mutex_);
  refused_ = given ? "" : std::string(given.error().reason);
}

void Keys::write_refusal() {
  std::string why;
  {
    const std::lock_guard lock(mutex_);
    why.swap(refused_);
  }
  if (!why.empty()) {
    write_all(STDERR_FILENO, std::string(ProgressBar::before_a_line()) + "not done: " + why + '\n');
  }
}

void Keys::press(char key) {
  const ControllerStatus status = by_->status();
  const bool holds =
      status.state == ControllerState::holding || status.state == ControllerState::held;
  if (key == ' ') {
    give(holds ? Asked::resume : Asked::hold);
  } else if (key == '\n' || key == '\r') {
    const bool is_idle = status.state == ControllerState::idle;
    give(is_idle ? Asked::start : Asked::resume);
  } else if (key == '+' || key == '=') {
    change_feed(feed_percent(status) + kFeedStep_percent);
  } else if (key == '-') {
    change_feed(feed_percent(status) - kFeedStep_percent);
  } else if (key == 's') {
    give(SingleBlock{.is_on = !status.single_block});
  } else if (key == 'q') {
    give(Asked::stop);
  } else {
    move_by_hand(key);
  }
}

void Keys::move_by_hand(char key) {
  const std::size_t axis = std::string_view("xyzXYZ").find(key);
  if (key == 'h') {
    give(Asked::home);
  } else if (axis != std::string_view::npos) {
    Jog step{.is_step = true};
    step.mm[axis % step.mm.size()] = axis < step.mm.size() ? -kStep_mm : kStep_mm;
    give(step);
  }
}

void Keys::change_feed(int percent) {
  Overrides overrides = by_->status().overrides;
  overrides.feed = 0.01 * std::clamp(percent, 0, kMaxFeed_percent);
  give(overrides);
}

}  // namespace kerf::program
