#include "programs/kerf/run/operator.hpp"

#include <chrono>

namespace kerf::program {

namespace {

constexpr char kEscape = '\x1b';
constexpr std::chrono::milliseconds kWait{50};

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
  }
}

std::string Operator::state_after(TickStatus status) const {
  if (emergency_) {
    return "EMERGENCY";
  }
  if (stop_) {
    return "stopping ";
  }
  if (status == TickStatus::held) {
    return "held     ";
  }
  if (status == TickStatus::waiting) {
    return "waiting  ";
  }
  return hold_ ? "holding  " : "running  ";
}

}  // namespace kerf::program
