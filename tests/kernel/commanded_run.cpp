#include "tests/kernel/commanded_run.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <random>
#include <vector>

#include <kerf/kernel.hpp>

#include "tests/kernel/planned_path.hpp"
#include "tests/kernel/random_program.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/smoothing_program.hpp"

namespace kerf::test {

namespace {

using interp::Setpoint;

constexpr std::int64_t kMaxCommandedTicks = 2'000'000;
constexpr std::int64_t kLatest = 700;  // ticks without planning

enum class Order : std::uint8_t { hold, late, override, single_block, stop, emergency_stop };

struct Timed {
  std::int64_t tick = 0;
  Order order = Order::hold;
  int ticks = 0;           // until the resume, or how long planning is late
  bool after_rest = true;  // the resume counts from the first held tick
  Overrides overrides{};
};

std::vector<Timed> random_orders(std::mt19937_64& random, std::int64_t whole_ticks) {
  const auto below = [&random](std::int64_t count) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(count));
  };
  std::vector<Timed> orders(static_cast<std::size_t>(1 + below(20)));
  for (Timed& timed : orders) {
    timed.tick = below(whole_ticks);
    timed.order = std::array{
        Order::late,     Order::hold,     Order::hold,
        Order::override, Order::override, Order::single_block}[static_cast<std::size_t>(below(6))];
    timed.overrides = {.feed = 0.02 * static_cast<double>(below(101)),
                       .rapid = 0.05 * static_cast<double>(1 + below(20))};
    timed.ticks = static_cast<int>(timed.order == Order::late ? below(kLatest) : 1 + below(60));
    timed.after_rest = below(3) != 0;
  }
  std::ranges::sort(orders, {}, &Timed::tick);
  const std::int64_t end = below(10);
  orders.back().order = end == 0   ? Order::emergency_stop
                        : end <= 2 ? Order::stop
                                   : orders.back().order;
  return orders;
}

// For a program in G64: 10 to 200 % of the spindle's speed with each override. In single block
// lines are not merged, so it has a path of its own: half of the programs go without.
void fit_to_milling(std::mt19937_64& random, std::vector<Timed>& orders) {
  const bool leaves_path = random() % 2 == 0;
  for (Timed& timed : orders) {
    timed.overrides.spindle = 0.1 * static_cast<double>(1 + random() % 20);
    if (leaves_path && timed.order == Order::single_block) {
      timed.order = Order::hold;
    }
  }
}

std::vector<Timed> override_steps(std::mt19937_64& random, std::int64_t whole_ticks) {
  constexpr std::int64_t kStepTicks = 10;
  std::vector<Timed> orders;
  for (std::int64_t tick = 0; tick < whole_ticks; tick += kStepTicks) {
    orders.push_back({.tick = tick,
                      .order = Order::override,
                      .overrides = {.feed = 0.02 * static_cast<double>(random() % 101)}});
  }
  return orders;
}

std::string to_text(const std::vector<Timed>& orders) {
  constexpr std::array<const char*, 6> kNames{"hold",         "late", "override",
                                              "single block", "stop", "emergency stop"};
  std::string text;
  for (const Timed& timed : orders) {
    text += std::to_string(timed.tick) + " " + kNames.at(static_cast<std::size_t>(timed.order)) +
            " " + std::to_string(timed.ticks) + (timed.after_rest ? "" : " early") + " " +
            std::to_string(timed.overrides.feed) + " " + std::to_string(timed.overrides.rapid) +
            " " + std::to_string(timed.overrides.spindle) + ", ";
  }
  return text;
}

// Answers waits after some ticks.
class Operator {
 public:
  Operator(Kernel& kernel, const std::vector<Timed>& orders) : kernel_(&kernel), next_(&orders) {}

  // Before each tick; false: planning is late.
  bool before(std::int64_t tick) {
    for (; at_ < next_->size() && (*next_)[at_].tick <= tick; ++at_) {
      const Timed& timed = (*next_)[at_];
      if (timed.order == Order::hold && resume_in_ < 0 && !stopped_) {
        kernel_->hold();
        held_at_ = tick;
        resume_in_ = timed.ticks;
        after_rest_ = timed.after_rest;
      } else if (timed.order == Order::late) {
        late_until_ = tick + timed.ticks;
      } else if (timed.order == Order::override) {
        kernel_->set_overrides(timed.overrides);
        zero_until_ = timed.overrides.feed == 0.0 ? tick + 300 : -1;
      } else if (timed.order == Order::single_block) {
        kernel_->set_single_block(timed.after_rest);
      } else if (timed.order == Order::stop) {
        kernel_->stop();
        stopped_ = true;
      } else if (timed.order == Order::emergency_stop) {
        kernel_->emergency_stop();
        stopped_ = emergency_ = true;
      }
    }
    if (tick == zero_until_) {
      kernel_->set_overrides({.feed = 0.7});
    }
    return tick >= late_until_;
  }
  void after(TickStatus status) {
    waited_ = status == TickStatus::waiting ? waited_ + 1 : 0;
    if (waited_ == kWaitTicks) {
      kernel_->resume();
      waited_ = 0;
    }
    resume_in_ -= resume_in_ > 0 && (!after_rest_ || status == TickStatus::held) ? 1 : 0;
    if (resume_in_ == 0) {
      kernel_->resume();
      resume_in_ = -1;
    }
  }
  [[nodiscard]] bool stopped() const { return stopped_; }
  [[nodiscard]] bool emergency() const { return emergency_; }
  // For a hold that ought to have brought the tool to rest by that tick.
  [[nodiscard]] bool waits_for_rest(std::int64_t tick) const {
    return resume_in_ > 0 && after_rest_ && !stopped_ && tick - held_at_ > kLatestRest;
  }

 private:
  static constexpr int kWaitTicks = 4;
  static constexpr std::int64_t kLatestRest = kLatest + kLongestStop_ticks;

  Kernel* kernel_;
  const std::vector<Timed>* next_;
  std::size_t at_ = 0;
  std::int64_t held_at_ = 0;
  int resume_in_ = -1;  // none waits
  bool after_rest_ = true;
  std::int64_t late_until_ = 0;
  std::int64_t zero_until_ = -1;  // the feed override is 0; -1: it is not
  int waited_ = 0;
  bool stopped_ = false;
  bool emergency_ = false;
};

bool is_over(TickStatus status) {
  return status == TickStatus::finished || status == TickStatus::failed ||
         status == TickStatus::emergency_stop;
}

bool is_going_on(TickStatus status) {
  return status == TickStatus::running || status == TickStatus::starved;
}

// Without commands.
std::vector<Setpoint> whole_run(const std::string& text, const KernelOptions& options) {
  Kernel kernel(mill(), options);
  kernel.feed(text);
  kernel.finish();
  std::vector<Setpoint> ticks(1);
  while (is_going_on(kernel.next(ticks.back())) &&
         ticks.size() < static_cast<std::size_t>(kMaxCommandedTicks)) {
    ticks.emplace_back();
  }
  return ticks;
}

}  // namespace

CommandedRun commanded_run(std::uint64_t seed, Commands commands, Programs programs) {
  constexpr std::array kKinds{ProfileKind::s_curve, ProfileKind::time_optimal,
                              ProfileKind::quintic};
  std::mt19937_64 random(seed);
  const bool mills = programs == Programs::milling;
  const RandomProgram program =
      mills ? milling_program(seed)
            : random_program(seed, {.blocks = 8, .longest_mm = seed % 3 == 0 ? 5.0 : 60.0});
  KernelOptions options{.profile = {.kind = kKinds[random() % kKinds.size()]}};
  options.start_mm = program.start_mm;
  const std::vector<Setpoint> whole = whole_run(program.text, options);
  const PlannedPath path(mill(), options, program.text);
  std::vector<Timed> orders = commands == Commands::all ? random_orders(random, whole.back().tick)
                                                        : override_steps(random, whole.back().tick);
  const bool has_threads = random() % 2 == 0;
  bool has_path_of_whole = true;
  if (mills) {
    fit_to_milling(random, orders);
    has_path_of_whole =
        std::ranges::find(orders, Order::single_block, &Timed::order) == orders.end();
    options.waits = true;
  }

  Kernel kernel(mill(), options);
  kernel.feed(program.text);
  kernel.finish();
  TickChecker checker(mill().limits, true);
  CommandedRun run{.commands = to_text(orders)};
  Operator by(kernel, orders);
  Setpoint setpoint;
  double off_mm = 0.0;
  bool starves_in_motion = false;
  TickStatus status = TickStatus::running;
  for (; !is_over(status) && run.ticks < kMaxCommandedTicks; ++run.ticks) {
    const bool in_time = by.before(run.ticks);
    if (has_threads) {
      if (in_time) {
        kernel.plan();
      }
      status = kernel.tick(setpoint);
    } else {
      status = kernel.next(setpoint);
    }
    if (in_time || !has_threads) {
      by.after(status);
    }
    if (!by.emergency()) {
      checker.add({.setpoint = setpoint, .feedrate_mm_s = 150.0});
    }
    off_mm = std::max(off_mm, has_path_of_whole ? path.off_mm(setpoint) : 0.0);
    starves_in_motion |= status == TickStatus::starved && setpoint.v_mm_s != 0.0;
    for (const double x : setpoint.position_mm) {
      run.fingerprint = run.fingerprint * 1'099'511'628'211U + std::bit_cast<std::uint64_t>(x);
    }
  }
  run.complaint = checker.complaint();
  run.worst = checker.worst();
  const auto complain = [&run](bool is_wrong, const std::string& what) {
    if (is_wrong && run.complaint.empty()) {
      run.complaint = what;
    }
  };
  complain(kernel.fault().has_value(), kernel.fault() ? kernel.fault()->what : "");
  complain(starves_in_motion, "starves in motion");
  complain(off_mm > 1e-9, std::to_string(off_mm) + " mm off the path");
  complain(!is_over(status), "does not end");
  complain(by.waits_for_rest(run.ticks), "was not held");
  complain(setpoint.v_mm_s != 0.0, "ends in motion");
  complain(!by.stopped() && setpoint.position_mm != whole.back().position_mm,
           "ends somewhere else");
  return run;
}

}  // namespace kerf::test
