#include "programs/kerf/run/operator.hpp"

#include <algorithm>
#include <chrono>

#include <spdlog/fmt/fmt.h>

namespace kerf::program {

namespace {

constexpr char kEscape = '\x1b';
constexpr std::chrono::milliseconds kWait{50};
constexpr int kFeedStep_percent = 10;
constexpr int kMostFeed_percent = 200;

}  // namespace

Operator::Operator(Kernel& kernel, bool has_keys) : kernel_(&kernel) {
  if (has_keys && keyboard_.emplace().is_open()) {
    thread_ = std::thread([this] { read_keys(); });
  }
}

Operator::~Operator() {
  over_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void Operator::read_keys() {
  while (!over_) {
    if (const auto key = keyboard_->key(kWait)) {
      press(*key);
    }
  }
}

void Operator::press(char key) noexcept {
  if (key == ' ') {
    hold_ = !hold_;
  } else if (key == '\n' || key == '\r') {
    hold_ = false;
    answer_ = true;
  } else if (key == '+' || key == '=') {
    feed_percent_ = std::min(feed_percent_ + kFeedStep_percent, kMostFeed_percent);
  } else if (key == '-') {
    feed_percent_ = std::max(feed_percent_ - kFeedStep_percent, 0);
  } else if (key == 's') {
    single_block_ = !single_block_;
  } else if (key == 'q') {
    stop_ = true;
  } else if (key == kEscape) {
    emergency_stop();
  }
}

void Operator::emergency_stop() noexcept {
  emergency_ = true;
  kernel_->emergency_stop();
}

void Operator::carry_out(Feeder& feeder) {
  if (stop_) {
    feeder.stop();
  } else if (hold_ != held_) {
    held_ = !held_;
    held_ ? kernel_->hold() : kernel_->resume();
    answer_ = false;
  } else if (answer_.exchange(false)) {
    kernel_->resume();
  } else if (const int percent = feed_percent_; percent != carried_feed_percent_) {
    carried_feed_percent_ = percent;
    kernel_->set_overrides({.feed = 0.01 * percent});
  } else if (const bool single_block = single_block_; single_block != carried_single_block_) {
    carried_single_block_ = single_block;
    kernel_->set_single_block(single_block);
  }
}

const char* Operator::state_after(TickStatus status) const noexcept {
  if (emergency_) {
    return "EMERGENCY";
  }
  if (stop_) {
    return "stopping";
  }
  if (status == TickStatus::held) {
    return "held";
  }
  if (status == TickStatus::waiting) {
    return "waiting";
  }
  return hold_ || feed_percent_ == 0 ? "holding" : "running";
}

std::string Operator::status_line(const Progress& progress) const {
  std::string state = fmt::format("{:9}", state_after(progress.status()));
  if (!has_keys()) {
    return state;
  }
  constexpr double kPerMinute = 60.0;
  return fmt::format("{} line {:<6} F{:<6.0f} {:3} %{}", state, progress.line(),
                     kPerMinute * progress.feedrate_mm_s(), feed_percent_.load(),
                     single_block_ ? " single block" : "");
}

}  // namespace kerf::program
