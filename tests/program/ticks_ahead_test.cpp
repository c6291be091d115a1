#include "programs/kerf/run/ticks_ahead.hpp"

#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "programs/kerf/run/planning_side.hpp"
#include "tests/program/no_memory.hpp"

namespace kerf::program {
namespace {

class GivenText final : public TextFeed {
 public:
  explicit GivenText(std::string_view text) : text_(text) {}
  tl::expected<TextPiece, std::string> read() override {
    const std::string_view piece = std::exchange(text_, {});
    return piece.empty() ? TextPiece{} : TextPiece{TextPiece::State::text, piece};
  }
  [[nodiscard]] double share_read() const noexcept override { return 1.0; }

 private:
  std::string_view text_;
};

// A probe touches below z = -5, and input 0 is high from tick 700 on.
ProgramInputs inputs_behind(const Setpoint& last) {
  ProgramInputs inputs{.probe = last.position_mm[2] < -5.0, .actual_mm = last.position_mm};
  inputs.digital = last.tick >= 700 ? 1U : 0U;
  return inputs;
}

KernelOptions options_of(const Position& start_mm) {
  return {.horizon_s = 3600.0,
          .asks_machine = true,
          .assumes_contact = true,
          .one_thread = true,
          .start_mm = start_mm};
}

std::vector<Setpoint> ticks_of_one_thread(std::string_view text, const Position& start_mm) {
  Kernel kernel(default_machine(), options_of(start_mm));
  kernel.feed(text);
  kernel.finish();
  std::vector<Setpoint> ticks;
  Setpoint setpoint{.position_mm = start_mm};
  for (TickStatus status{}; status == TickStatus::running;) {
    kernel.set_program_inputs(inputs_behind(setpoint));
    status = kernel.next(setpoint);
    ticks.push_back(setpoint);
  }
  return ticks;
}

struct Made {
  std::vector<Setpoint> ticks;
  TickStatus end{};
};

Made ticks_ahead(std::string_view text, const Position& start_mm, std::size_t most) {
  Kernel kernel(default_machine(), options_of(start_mm));
  KernelPlanning side(kernel);
  GivenText whole(text);
  Progress progress;
  Feeder feeder(side, whole, progress);
  PlanningBeside planning(kernel, feeder);
  TicksAhead ahead(kernel, planning);
  Made made;
  Setpoint last{.position_mm = start_mm};
  while (made.end == TickStatus::running && made.ticks.size() < most) {
    const TicksAhead::Tick& tick = ahead.next([&] { return inputs_behind(last); });
    last = tick.setpoint;
    made.ticks.push_back(last);
    made.end = tick.status;
  }
  return made;
}

void expect_those_of_one_thread(std::string_view text, const Position& start_mm = {}) {
  const std::vector<Setpoint> one = ticks_of_one_thread(text, start_mm);
  const Made made = ticks_ahead(text, start_mm, one.size() + 1);
  EXPECT_EQ(made.end, TickStatus::finished);
  ASSERT_EQ(made.ticks.size(), one.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(made.ticks[i].tick, one[i].tick);
    ASSERT_EQ(made.ticks[i].line, one[i].line) << i;
    ASSERT_EQ(made.ticks[i].position_mm, one[i].position_mm) << i;
    ASSERT_EQ(made.ticks[i].a_mm_s2, one[i].a_mm_s2) << i;
    ASSERT_EQ(made.ticks[i].outputs, one[i].outputs) << i;
  }
}

TEST(TicksAhead, AreThoseOfOneThread) {
  expect_those_of_one_thread("M2\n");
  expect_those_of_one_thread(
      "G21 G90 G64 P0.01 Q0.01 F3000\nS1000 M3\nG1 X10\nY10 M62 P1\nG2 X20 Y0 I0 J-10\nG4 P0.05\n"
      "M8\nG5 X30 Y0 I3 J3 P-3 Q3\nG0 Z5\nG1 X29.9999\nX29.9998\nG0 X0 Y0\nM2\n",
      {1.0, 2.0, 0.0});
}

TEST(TicksAhead, AreThoseOfOneThreadWhereTheMachineIsAsked) {
  expect_those_of_one_thread(
      "G21 G90 G94\nG1 X10 F3000\nG38.2 Z-20 F600\nG0 Z1\nM66 P0 L3 Q5\n"
      "G4 P0.1\nG1 X#5063\nG38.2 Z-30 F300\nG1 X0\nM2\n");
}

TEST(TicksAhead, EndWhereNoMoreAreWanted) {
  for (const std::size_t most : {std::size_t{1}, std::size_t{100}, std::size_t{1000}}) {
    EXPECT_EQ(ticks_ahead("G21 G90\nG1 X400 F600\nM2\n", {}, most).ticks.size(), most);
    EXPECT_EQ(ticks_ahead("G21 G90\nG1 X5 F3000\nG38.2 Z-20 F60\nM2\n", {}, most).ticks.size(),
              most);
  }
}

TEST(TicksAhead, ThrowWhatPlanningThrew) {
  Kernel kernel(default_machine(), options_of({}));
  NoMemory side(kernel);
  GivenText text("");
  Progress progress;
  Feeder feeder(side, text, progress);
  PlanningBeside planning(kernel, feeder);
  TicksAhead ahead(kernel, planning);
  EXPECT_THROW(ahead.next([] { return ProgramInputs{}; }), std::bad_alloc);
}

}  // namespace
}  // namespace kerf::program
