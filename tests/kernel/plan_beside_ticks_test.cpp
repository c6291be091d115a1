// Without a clock, a thread reads, another plans and a third ticks: whoever needs more waits for
// it.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/random_program.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/smoothing_program.hpp"

namespace kerf::test {
namespace {

// Feeds a kernel piece by piece.
class Text {
 public:
  Text(Kernel& kernel, std::string_view text) : kernel_(kernel), text_(text) {}

  void feed() {
    constexpr std::size_t kPiece = 100;
    kernel_.feed(text_.substr(0, kPiece));
    text_.remove_prefix(std::min(kPiece, text_.size()));
    if (text_.empty()) {
      kernel_.finish();
    }
  }

 private:
  Kernel& kernel_;
  std::string_view text_;
};

// Reads as far ahead as it may, with all text that is wanted.
class Reader {
 public:
  Reader(Kernel& kernel, std::string_view text)
      : kernel_(kernel), text_(kernel, text), thread_([this] { work(); }) {}
  ~Reader() {
    over_ = true;
    thread_.join();
  }

 private:
  void work() {
    for (ReadStatus status{}; !over_ && status != ReadStatus::ended;) {
      status = kernel_.read();
      if (status == ReadStatus::wants_text) {
        text_.feed();
      } else if (status == ReadStatus::far_enough) {
        std::this_thread::yield();
      }
    }
  }

  Kernel& kernel_;
  Text text_;
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

// Plans again whenever it is asked to. Text comes from it, or a reader has it.
class Planner {
 public:
  Planner(Kernel& kernel, std::optional<Text> text)
      : kernel_(kernel), text_(text), thread_([this] { work(); }) {}
  ~Planner() {
    over_ = true;
    thread_.join();
  }

  // Before a tick.
  void reach_tick() {
    while (lacks_plan()) {
      const std::uint64_t block = kernel_.detail().block;
      kernel_.make_room();
      if (kernel_.detail().block == block) {
        return;
      }
    }
  }

 private:
  bool lacks_plan() {
    if (!kernel_.needs_plan()) {
      return false;
    }
    const int number = ++wanted_;
    while (kernel_.needs_plan() && done_ < number) {
      std::this_thread::yield();
    }
    return kernel_.needs_plan();
  }

  void work() {
    while (!over_) {
      const int number = wanted_;
      while (number > done_ && kernel_.plan()) {
        if (text_) {
          text_->feed();
        } else {
          std::this_thread::yield();
        }
      }
      done_ = number;
      std::this_thread::yield();
    }
  }

  Kernel& kernel_;
  std::optional<Text> text_;
  std::atomic<int> wanted_ = 0;
  std::atomic<int> done_ = 0;
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

// Of a machine whose probe touches below z = -5, and whose input 0 is high from tick 700 on.
ProgramInputs inputs_at(const Setpoint& setpoint) {
  ProgramInputs inputs{.probe = setpoint.position_mm[2] < -5.0, .actual_mm = setpoint.position_mm};
  inputs.digital = setpoint.tick >= 700 ? 1U : 0U;
  return inputs;
}

struct Program {
  std::string text;
  KernelOptions options{};
};

template <typename ReachTick>
std::vector<Setpoint> run(Kernel& kernel, const ReachTick& reach_tick) {
  std::vector<Setpoint> ticks;
  Setpoint setpoint;
  TickStatus status = TickStatus::running;
  while ((status == TickStatus::running || status == TickStatus::waiting) &&
         ticks.size() < kMaxTicks) {
    reach_tick();
    kernel.set_program_inputs(inputs_at(setpoint));
    status = kernel.tick(setpoint);
    ticks.push_back(setpoint);
  }
  EXPECT_EQ(status, TickStatus::finished);
  EXPECT_FALSE(kernel.fault()) << kernel.fault()->what;
  return ticks;
}

std::vector<Setpoint> ticks_of_one_thread(const Program& program) {
  Kernel kernel(mill(), program.options);
  kernel.feed(program.text);
  kernel.finish();
  return run(kernel, [&] {
    kernel.plan();
    kernel.reach_tick();
  });
}

std::vector<Setpoint> ticks_beside(const Program& program) {
  Kernel kernel(mill(), program.options);
  std::optional<Reader> reader;
  std::optional<Text> text;
  if (program.options.reads_apart) {
    reader.emplace(kernel, program.text);
  } else {
    text.emplace(kernel, program.text);
  }
  Planner planner(kernel, text);
  return run(kernel, [&] { planner.reach_tick(); });
}

bool is_same(const Setpoint& a, const Setpoint& b) {
  return a.tick == b.tick && a.line == b.line && a.position_mm == b.position_mm &&
         a.velocity_mm_s == b.velocity_mm_s && a.acceleration_mm_s2 == b.acceleration_mm_s2 &&
         a.s_mm == b.s_mm && a.v_mm_s == b.v_mm_s && a.a_mm_s2 == b.a_mm_s2 &&
         a.j_mm_s3 == b.j_mm_s3 && a.limit == b.limit && a.rapid == b.rapid &&
         a.extra_rad_mm == b.extra_rad_mm && a.outputs == b.outputs;
}

#ifdef KERF_SLOW_BUILD
constexpr std::array kHorizons_s{3600.0};
#else
constexpr std::array kHorizons_s{0.05, 3600.0};
#endif

void expect_the_same(Program program) {
  program.options.one_thread = true;
  const std::vector<Setpoint> one = ticks_of_one_thread(program);
  for (const double horizon_s : kHorizons_s) {
    for (const bool reads_apart : {false, true}) {
      SCOPED_TRACE(horizon_s);
      SCOPED_TRACE(reads_apart);
      program.options.horizon_s = horizon_s;
      program.options.reads_apart = reads_apart;
      const std::vector<Setpoint> many = ticks_beside(program);
      ASSERT_EQ(many.size(), one.size());
      for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_TRUE(is_same(many[i], one[i])) << "tick " << i;
      }
    }
  }
}

TEST(PlanBesideTicks, GivesTheTicksOfOneThread) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    SCOPED_TRACE(name_of(kind));
    expect_the_same({.text = mixed_program(), .options = {.profile = {.kind = kind}}});
  }
}

TEST(PlanBesideTicks, GivesTheTicksOfOneThreadOnRandomPrograms) {
#ifdef KERF_SLOW_BUILD
  constexpr std::uint64_t kPrograms = 5;
#else
  constexpr std::uint64_t kPrograms = 20;
#endif
  for (std::uint64_t seed = 1; seed <= kPrograms; ++seed) {
    SCOPED_TRACE(seed);
    const RandomProgram mixed = random_program(seed, {.longest_mm = 50.0});
    expect_the_same({.text = mixed.text, .options = {.start_mm = mixed.start_mm}});
    const RandomProgram smoothed = smoothing_program(seed);
    expect_the_same({.text = smoothed.text, .options = {.start_mm = smoothed.start_mm}});
  }
}

// More blocks in one tick than the queue holds.
#ifdef KERF_SLOW_BUILD
constexpr int kRow = 300;  // of 1,500 the sanitizers make ten minutes
#else
constexpr int kRow = 1500;
#endif

TEST(PlanBesideTicks, PassesRowsOfBlocksThatAreShorterThanATick) {
  std::string text = "G21 G90 G61 F6000\nG1 X1\n";
  for (int i = 1; i <= kRow; ++i) {
    text += "G1 X" + std::to_string(1.0 + 1e-5 * i) + "\n";
  }
  expect_the_same({.text = text + "G1 X2\nM2\n"});
}

TEST(PlanBesideTicks, WaitsForWhatTheMachineAnswers) {
  expect_the_same({.text = "G21 G90 G94\nG1 X10 F3000\nG38.2 Z-20 F600\nG0 Z1\nM66 P0 L3 Q5\n"
                           "G4 P0.1\nG1 X#5063\nG38.2 Z-30 F300\nG1 X0\nM2\n",
                   .options = {.asks_machine = true}});
}

}  // namespace
}  // namespace kerf::test
