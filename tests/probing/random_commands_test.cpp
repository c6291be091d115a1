// Programs of probes and inputs, to which an operator gives commands at random ticks.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

constexpr unsigned kPrograms = 40;
// A takeover a rounding before a block's end went back on it; single block hung before an M66.
constexpr std::array kFoundAFault{476U, 833U};
constexpr std::int64_t kQuietFrom = 40'000;  // ticks: from then on nobody disturbs the program
constexpr Position kEnd_mm{1.0, 2.0, 10.0};

// KERF_RANDOM_SEED and KERF_RANDOM_PROGRAMS ask for others and more.
unsigned number_of(const char* name, unsigned otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
}

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}

  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  bool one_in(unsigned n) { return random_() % n == 0; }

 private:
  std::mt19937 random_;
};

std::string random_program(Dice& dice) {
  std::ostringstream text;
  text << std::fixed << "G21 G90 G94 F600 " << (dice.one_in(3) ? "G64 P0.05" : "G61") << '\n';
  const int touches = static_cast<int>(dice.between(2.0, 6.0));
  for (int i = 0; i < touches; ++i) {
    text << "G0 Z" << dice.between(8.0, 12.0) << "\nG0 X" << dice.between(-20.0, 20.0) << " Y"
         << dice.between(-20.0, 20.0) << '\n';
    text << (dice.one_in(4) ? "G38.3" : "G38.2") << " Z" << dice.between(-20.0, -10.0) << " F"
         << dice.between(30.0, 3000.0) << '\n';
    if (dice.one_in(3)) {
      text << "G38.5 Z" << dice.between(8.0, 12.0) << " F" << dice.between(30.0, 1000.0) << '\n';
    }
    if (dice.one_in(3)) {
      text << (dice.one_in(2) ? "M66 P1 L3 Q0.2\n" : "M66 E0 L0\n");
    }
    text << "G1 Z" << dice.between(8.0, 12.0) << " F" << dice.between(300.0, 3000.0) << "\nG1 X"
         << dice.between(-20.0, 20.0) << "\nG1 Y" << dice.between(-20.0, 20.0) << '\n';
  }
  text << "G0 Z10\nG0 X1 Y2\nM2\n";
  return text.str();
}

// Holds and resumes, other overrides, single block; and input 1 changes now and then.
class RandomOperator {
 public:
  explicit RandomOperator(unsigned seed) : dice_(seed) {}

  void command(Kernel& kernel, const TableRun& run, ProgramInputs& inputs) {
    const auto tick = static_cast<std::int64_t>(run.ticks.size());
    input_ = input_ != dice_.one_in(50);
    inputs.digital = input_ ? 2U : 0U;
    const bool is_long = tick - given_ > 20;
    if (is_held_ && (tick > kQuietFrom || (is_long && dice_.one_in(200)))) {
      kernel.resume();
      is_held_ = false;
      given_ = tick;
    } else if (run.status == TickStatus::waiting && is_long) {
      kernel.resume();  // after a block, in single block
      given_ = tick;
    }
    if (tick == kQuietFrom) {
      kernel.set_overrides({});
      kernel.set_single_block(false);
    } else if (tick < kQuietFrom && dice_.one_in(150)) {
      give(kernel);
      given_ = tick;
    }
  }

 private:
  void give(Kernel& kernel) {
    if (dice_.one_in(3)) {
      kernel.hold();
      is_held_ = true;
    } else if (dice_.one_in(3)) {
      steps_ = !steps_;
      kernel.set_single_block(steps_);
    } else if (dice_.one_in(3)) {
      kernel.set_overrides({});
    } else {
      kernel.set_overrides({.feed = dice_.one_in(6) ? 0.0 : dice_.between(0.2, 2.0),
                            .rapid = dice_.between(0.1, 1.0)});
    }
  }

  Dice dice_;
  std::int64_t given_ = 0;  // the tick of the latest command
  bool input_ = false;
  bool is_held_ = false;
  bool steps_ = false;
};

TEST(RandomProbeCommands, LeaveLimitsAndTheEndOfAProgramThatAsksTheMachine) {
  const unsigned first = number_of("KERF_RANDOM_SEED", 1);
  const unsigned count = number_of("KERF_RANDOM_PROGRAMS", kPrograms);
  std::cout << "seeds " << first << " to " << first + count - 1 << '\n';
  std::vector<unsigned> seeds{kFoundAFault.begin(), kFoundAFault.end()};
  for (unsigned seed = first; seed < first + count; ++seed) {
    seeds.push_back(seed);
  }
  for (const unsigned seed : seeds) {
    Dice dice(seed);
    const MachineSettings settings =
        touching(TouchPlane{.point_mm = {0.0, 0.0, -2.0},
                            .normal = {dice.between(-0.3, 0.3), dice.between(-0.3, 0.3), 1.0}},
                 dice.one_in(2));
    const std::string program = random_program(dice);
    SCOPED_TRACE("seed " + std::to_string(seed));
    TableOrder order;
    order.options.profile.kind = dice.one_in(2) ? ProfileKind::s_curve : ProfileKind::time_optimal;
    order.options.waits = true;
    order.plans_every = dice.one_in(2) ? static_cast<std::int64_t>(dice.between(1.0, 31.0)) : 0;
    RandomOperator by(seed + 1'000'000);
    order.before = [&by](Kernel& kernel, const TableRun& run, ProgramInputs& inputs) {
      by.command(kernel, run, inputs);
    };
    const TableRun run = whole_run(settings, program, order);
    EXPECT_EQ(run.ticks.back().position_mm, kEnd_mm) << program;
  }
}

}  // namespace
}  // namespace kerf::test
