// The path of a program that starts at one of its blocks, beside that of the whole.
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "curves/curve.hpp"
#include "kernel/program_path.hpp"
#include "tests/kernel/run.hpp"

namespace kerf {
namespace {

using test::Setpoint;

// The path as it is run, and the blocks that its parts begin with.
struct PathPart {
  std::uint64_t block = 0;
  std::vector<curves::Position> places;  // of a rest one
};

std::vector<PathPart> path_of(const std::string& text, const MachineSettings& settings,
                              std::optional<StartInProgram> start) {
  KernelOptions options;
  options.start_in_program = start;
  ProgramPath path(settings, options, {});
  path.feed(text);
  path.finish();
  std::vector<PathPart> parts;
  for (ProgramPath::Output output; path.next(output) == ProgramPath::Next::output;) {
    PathPart& part = parts.emplace_back();
    part.block = first_block(output);
    if (const auto* segment = std::get_if<smoothing::PathSegment>(&output)) {
      const double length = curves::length_mm(segment->curve);
      for (int i = 0; i <= 8; ++i) {
        part.places.push_back(curves::position_at(segment->curve, length * i / 8.0));
      }
    } else {
      part.places.push_back(std::get<parser::Move>(output).start_mm);
    }
  }
  EXPECT_FALSE(path.has_errors());
  return parts;
}

// Of every start that the path has: how many there were.
int compare_all_starts(const std::string& text) {
  const MachineSettings settings = default_machine();
  const auto whole = path_of(text, settings, std::nullopt);
  std::uint64_t block = 0;
  int starts = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole[i].block == block) {
      continue;
    }
    block = whole[i].block;
    SCOPED_TRACE(block);
    const auto rest = path_of(text, settings, StartInProgram{.blocks_before = block - 1});
    const std::size_t same = whole.size() - i;
    EXPECT_GE(rest.size(), same);
    const std::size_t way = rest.size() - same;
    for (std::size_t k = 0; k < same; ++k) {
      EXPECT_EQ(rest[way + k].places, whole[i + k].places);
    }
    // The way there ends where they begin.
    for (std::size_t axis = 0; way > 0 && axis < 3; ++axis) {
      EXPECT_NEAR(rest[way - 1].places.back()[axis], whole[i].places.front()[axis], 1e-9);
    }
    ++starts;
  }
  return starts;
}

// Wherever the path of a program has a part that begins with a block, the path from there on is bit
// for bit the same.
TEST(PathFromBlock, IsThatOfTheWhole) {
  for (const char* name : {"pocket.ngc", "star.ngc", "scroll.ngc", "mazatrol.ngc"}) {
    SCOPED_TRACE(name);
    EXPECT_GT(compare_all_starts(test::shipped_program(name)), 3);
  }
}

// Rounded corners and merged lines with it: lines of 0.5 mm along a circle's edge, then long ones.
TEST(PathFromBlock, IsThatOfTheWholeAsG64MakesIt) {
  std::string text = "G21 G90 G64 P0.05 Q0.02 F1200\nG1 X40\n";
  for (int row = 0; row < 3; ++row) {
    for (int i = 1; i <= 60; ++i) {
      const double angle = i * 0.0125;
      text += "X" + std::to_string(40.0 * std::cos(angle)) + " Y" +
              std::to_string(40.0 * std::sin(angle)) + "\n";
    }
    text += "X0 Y0\nZ" + std::to_string(-row) + "\nX10\nY-10\nX40 Y0\n";
  }
  text += "M2\n";
  EXPECT_GT(compare_all_starts(text), 15);
  EXPECT_GT(compare_all_starts("#1=0\no1 while [#1 LT 5]\n#1=[#1+1]\nG1 X#1 F600\nG3 X[#1+1] I0.5\n"
                               "G1 Y#1\nG4 P0.1\no1 endwhile\nM2\n"),
            12);
}

TEST(PathFromBlock, EndsWhereTheWholeEndsToTheLastBit) {
  const std::string text = test::shipped_program("pocket.ngc");
  const auto end_from = [&](std::optional<StartInProgram> start) {
    KernelOptions options;
    options.start_in_program = start;
    Kernel kernel(default_machine(), options);
    kernel.feed(text);
    kernel.finish();
    Setpoint setpoint;
    TickStatus status = TickStatus::running;
    while (status == TickStatus::running) {
      status = kernel.next(setpoint);
    }
    EXPECT_EQ(status, TickStatus::finished);
    EXPECT_FALSE(kernel.fault()) << kernel.fault()->what;
    return setpoint;
  };
  const Setpoint whole = end_from(std::nullopt);
  const auto parts = path_of(text, default_machine(), std::nullopt);
  for (std::size_t i = parts.size() / 2; i < parts.size(); i += 15) {
    const Setpoint end = end_from(StartInProgram{.blocks_before = parts[i].block - 1});
    EXPECT_EQ(end.position_mm, whole.position_mm);
    EXPECT_EQ(end.outputs, whole.outputs);
  }
}

}  // namespace
}  // namespace kerf
