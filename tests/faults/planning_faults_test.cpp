// Rows 57, 59 and 62 of the faults; row 52 is tests/kernel/settings_check_test.cpp, row 58
// other_builds_test.py.
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kerf.hpp>

#include "diagnostics/errors/pages.hpp"
#include "parser/program_reader.hpp"

namespace kerf::faults {
namespace {

constexpr std::array kAllProfiles{
    ProfileKind::time_optimal, ProfileKind::s_curve,     ProfileKind::sigmoid,  ProfileKind::sine,
    ProfileKind::quintic,      ProfileKind::sine_series, ProfileKind::trapezoid};

// Runs what is fed to its end; `look` sees every tick.
template <class Look>
void run(Kernel& kernel, Look look) {
  Setpoint setpoint;
  TickStatus status = TickStatus::running;
  while (status == TickStatus::running) {
    status = kernel.next(setpoint);
    look(setpoint);
  }
  EXPECT_EQ(status, TickStatus::finished);
  for (const diagnostics::Diagnostic& diagnostic : kernel.diagnostics()) {
    ADD_FAILURE() << to_string(diagnostic, "program");
  }
}

std::vector<Setpoint> ticks_of(const std::string& text, ProfileKind kind,
                               const MachineSettings& machine = default_machine()) {
  Kernel kernel(machine, {.profile = {.kind = kind}});
  kernel.feed(text);
  kernel.finish();
  std::vector<Setpoint> ticks;
  run(kernel, [&](const Setpoint& setpoint) { ticks.push_back(setpoint); });
  return ticks;
}

bool same_motion(const Setpoint& a, const Setpoint& b) {
  return a.line == b.line && a.s_mm == b.s_mm && a.v_mm_s == b.v_mm_s && a.a_mm_s2 == b.a_mm_s2 &&
         a.j_mm_s3 == b.j_mm_s3 && a.position_mm == b.position_mm &&
         a.velocity_mm_s == b.velocity_mm_s && a.acceleration_mm_s2 == b.acceleration_mm_s2;
}

TEST(PlanningFaults, Row57ASecondRunInTheProcessHasTheSameTicks) {
  const std::string program =
      "G64 P0.05 Q0.01\nG1 X30 F3600\nG3 X30 Y20 J10\nG1 X0\nG1 X-1 Y19.9\nG1 X-2 Y19.7\nG1 X-3 "
      "Y19.4\n"
      "G61 G1 Y5\nG4 P0.01\nG0 X0 Y0\nG5.1 X20 Y0 I10 J15 F2000\nM2\n";
  for (const ProfileKind kind : kAllProfiles) {
    SCOPED_TRACE(name_of(kind));
    const std::vector<Setpoint> first = ticks_of(program, kind);
    for (const ProfileKind other : kAllProfiles) {
      ticks_of("G91 G1 X3 F5000\nY1\nX-9 Y2\nG2 X5 I2.5\nM2\n", other);
    }
    const std::vector<Setpoint> second = ticks_of(program, kind);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      ASSERT_TRUE(first[i].tick == second[i].tick && same_motion(first[i], second[i])) << i;
    }
  }
}

TEST(PlanningFaults, Row59AMillionRelativeMovesEndWhereTheirSumIs) {
  constexpr int kMoves = 1'000'000;
  Kernel kernel(default_machine(),
                {.profile = {.kind = ProfileKind::s_curve}, .window_blocks = 100});
  kernel.feed("G91 G1 F12000\n");
  Setpoint setpoint;
  std::int64_t ticks = 0;
  const auto tick = [&] {
    const TickStatus status = kernel.next(setpoint);
    EXPECT_EQ(setpoint.tick, ticks++);
    return status;
  };
  for (int i = 0; i < kMoves; ++i) {
    kernel.feed("X0.001 Y-0.0003\n");
    if (i % 1000 == 999) {
      while (!kernel.plan()) {
        tick();
      }
    }
  }
  kernel.finish();
  while (tick() == TickStatus::running) {
  }
  EXPECT_FALSE(kernel.has_errors());
  EXPECT_NEAR(setpoint.position_mm[0], 1000.0, 1e-9);
  EXPECT_NEAR(setpoint.position_mm[1], -300.0, 1e-9);
}

// Steps of whole hundred-thousandths, so that integers have their sum.
TEST(PlanningFaults, Row59RelativeMovesOfAnyLengthEndWhereTheirSumIs) {
  for (const std::int64_t drift : {0, 40}) {
    parser::ProgramReader reader(parser::ReaderOptions{});
    reader.feed("G91 G1 F100\n");
    std::uint64_t state = 7;
    std::int64_t sum = 0;
    parser::Point end_mm{};
    parser::Move move;
    for (int i = 0; i < 1'000'000; ++i) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      const std::int64_t step = static_cast<std::int64_t>(state >> 33U) % 1001 - 500 + drift;
      sum += step;
      const std::string digits = std::to_string(100'000 + (step < 0 ? -step : step)).substr(1);
      reader.feed((step < 0 ? "X-0." : "X0.") + digits + "\n");
      while (reader.next(move)) {
        if (const auto* line = std::get_if<parser::LineMove>(&move.shape)) {
          end_mm = line->end_mm;
        }
      }
    }
    ASSERT_FALSE(reader.has_errors()) << reader.diagnostics().front().message;
    EXPECT_NEAR(end_mm[0], static_cast<double>(sum) * 1e-5, 1e-12) << drift;
  }
}

MachineSettings slow_clock() {
  MachineSettings machine = default_machine();
  machine.limits.period_s = 0.1;
  machine.table.period_s = 0.1;
  return machine;
}

TEST(PlanningFaults, Row59MotionAfterADayOfDwellIsThatWithoutIt) {
  constexpr std::int64_t kTicksOfADay = 864'000;
  const std::string before = "G1 X10 F600\n";
  const std::string after = "G1 X17.3 Y4\nG2 X20 Y10 R20\nM2\n";
  for (const ProfileKind kind : {ProfileKind::time_optimal, ProfileKind::sine}) {
    const auto alone = ticks_of(before + "G4 P1\n" + after, kind, slow_clock());
    Kernel kernel(slow_clock(), {.profile = {.kind = kind}});
    kernel.feed(before + "G4 P86400\n" + after);
    kernel.finish();
    std::int64_t ticks = 0;
    const auto behind_dwell = [&](std::int64_t tick) { return tick - kTicksOfADay + 10; };
    run(kernel, [&](const Setpoint& setpoint) {
      ASSERT_EQ(setpoint.tick, ticks++);
      const std::int64_t same = behind_dwell(setpoint.tick);
      if (same >= 0 && static_cast<std::size_t>(same) < alone.size() &&
          alone[static_cast<std::size_t>(same)].line > 2) {
        ASSERT_TRUE(same_motion(setpoint, alone[static_cast<std::size_t>(same)])) << setpoint.tick;
      }
    });
    EXPECT_EQ(behind_dwell(ticks), static_cast<std::int64_t>(alone.size()));
  }
}

TEST(PlanningFaults, Row59ADayOfSlowMotionIsAsFastAtItsEndAsAtItsBegin) {
  Kernel kernel(slow_clock(), {.profile = {.kind = ProfileKind::s_curve}});
  kernel.feed("G1 X432 F0.3\nM2\n");  // 24 h
  kernel.finish();
  constexpr std::int64_t kEvery = 1000;
  std::vector<double> x_mm;  // at every 1000th tick
  std::int64_t ticks = 0;
  double end_mm = 0.0;
  run(kernel, [&](const Setpoint& setpoint) {
    EXPECT_EQ(setpoint.tick, ticks);
    if (ticks++ % kEvery == 0) {
      x_mm.push_back(setpoint.position_mm[0]);
    }
    end_mm = setpoint.position_mm[0];
  });
  EXPECT_EQ(end_mm, 432.0);
  ASSERT_EQ(x_mm.size(), 865U);
  const double step_mm = (x_mm[863] - x_mm[1]) / 862.0;
  EXPECT_NEAR(step_mm, 0.3 / 60.0 * 0.1 * kEvery, 1e-10);
  for (std::size_t i = 1; i < 864; ++i) {
    // On its way the path length is summed over phases of a tenth of a second.
    EXPECT_NEAR(x_mm[i], x_mm[1] + step_mm * static_cast<double>(i - 1), 1e-8) << i;
  }
}

struct FarJump {
  std::string text;
  const diagnostics::ErrorPage* page;
  unsigned line;
};

TEST(PlanningFaults, Row62AFarJumpIsRefusedInMachineCoordinatesBeforeItStarts) {
  const std::vector<FarJump> jumps{
      {"G10 L2 P1 X999999\nG0 X0\n", &errors::kOutsideTravel, 2},
      {"G10 L2 P2 Y-600\nG0 X1\nG0 Y0\nG55 G0 Y10\n", &errors::kOutsideTravel, 4},
      {"G92 X999999\nG0 X0\n", &errors::kOutsideTravel, 2},
      {"G52 Z250\nG1 Z-10 F100\nG0 Z0\n", &errors::kOutsideTravel, 2},
      {"G43.1 Z300\nG0 Z0\n", &errors::kOutsideTravel, 2},
      {"G91\nG0 X400\nG0 X100\nG0 X0.001\n", &errors::kOutsideTravel, 4},
      {"G53 G0 X500.001\n", &errors::kOutsideTravel, 1},
      {"G10 L2 P1 X400\nG53 G0 X400\nG0 X101\n", &errors::kOutsideTravel, 3},
      {"G92 X-999999\nG0 X999999\n", &errors::kPositionOutOfRange, 2},
      {"G91\nG53 G0 X1\n", &errors::kMachineIncremental, 2},
  };
  for (const FarJump& jump : jumps) {
    SCOPED_TRACE(jump.text);
    bool given = false;
    const auto text = [&]() -> std::string_view {
      return std::exchange(given, true) ? std::string_view{} : std::string_view(jump.text);
    };
    const CheckReport report = check_program(text, default_machine());
    const auto& found = report.limit_faults.empty() ? report.diagnostics : report.limit_faults;
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].page, jump.page) << found[0].message;
    EXPECT_EQ(found[0].source.line, jump.line);

    Kernel kernel(default_machine(), {.checks_travel = true});
    kernel.feed(jump.text + "M2\n");
    kernel.finish();
    Setpoint setpoint;
    while (kernel.next(setpoint) == TickStatus::running) {
      ASSERT_LE(std::fabs(setpoint.position_mm[0]), 500.0);
      ASSERT_LE(std::fabs(setpoint.position_mm[2]), 200.0);
      ASSERT_LT(setpoint.line, jump.line);
    }
    ASSERT_FALSE(kernel.diagnostics().empty());
    EXPECT_EQ(kernel.diagnostics()[0].page, jump.page);
    EXPECT_EQ(kernel.diagnostics()[0].source.line, jump.line);
  }
}

TEST(PlanningFaults, Row62AFarOriginAloneIsNoFarWay) {
  const auto ticks = ticks_of("G92 X999999\nG0 X999999.5\nM2\n", ProfileKind::time_optimal);
  EXPECT_NEAR(ticks.back().position_mm[0], 0.5, 1e-9);
  for (const Setpoint& setpoint : ticks) {
    EXPECT_TRUE(setpoint.position_mm[0] >= 0.0 && setpoint.position_mm[0] <= 0.5 + 1e-9);
  }
}

}  // namespace
}  // namespace kerf::faults
