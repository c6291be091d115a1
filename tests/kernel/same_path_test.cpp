// Whatever an operator asks for, the path that crosses to the tick side is the same to the last
// bit: its pieces, their ranges, and where each curve begins.
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "kernel/pipeline.hpp"
#include "tests/kernel/shipped_text.hpp"

namespace kerf::test {
namespace {

struct StretchOfLine {
  std::uint64_t curve = 0;
  double begin_mm = 0.0;
  double end_mm = 0.0;
  std::array<curves::Position, 5> places_mm{};

  friend bool operator==(const StretchOfLine&, const StretchOfLine&) = default;
};

StretchOfLine stretch_of(const interp::CurvePiece& piece) {
  StretchOfLine stretch{.curve = piece.curve,
                        .begin_mm = curves::s_begin_mm(piece.geometry),
                        .end_mm = curves::s_end_mm(piece.geometry)};
  for (std::size_t i = 0; i < stretch.places_mm.size(); ++i) {
    const double share = static_cast<double>(i) / 4.0;
    stretch.places_mm[i] = curves::position_at(
        piece.geometry, stretch.begin_mm + share * (stretch.end_mm - stretch.begin_mm));
  }
  return stretch;
}

struct Path {
  std::vector<StretchOfLine> stretches;
  std::map<std::uint64_t, double> begins_mm;  // path length, by curve
  std::uint32_t plans = 0;

  void add(lookahead::Outbox& outbox) {
    for (const interp::CurvePiece& piece : outbox.pieces) {
      stretches.push_back(stretch_of(piece));
    }
    for (const interp::Phase& phase : outbox.phases) {
      plans = phase.plan;
      if (phase.s_end_mm > phase.s_begin_mm) {
        const auto [at, is_new] = begins_mm.emplace(phase.curve, phase.path_begin_mm);
        EXPECT_TRUE(is_new || at->second == phase.path_begin_mm) << phase.curve;
      }
    }
    outbox.clear();
  }
};

// command: before what is emitted has come to that tick; gets the tick.
using PipelineCommand = std::function<void(Pipeline&, lookahead::Outbox&, std::int64_t)>;
Path path_under(ProfileKind kind, std::int64_t every_ticks, const PipelineCommand& command) {
  const KernelOptions options{.profile = {.kind = kind}};
  const MachineSettings settings = mill();
  Pipeline pipeline({.settings = settings, .options = options, .may_hold = true});
  pipeline.feed(mixed_program());
  pipeline.finish();
  Path path;
  lookahead::Outbox outbox;
  std::int64_t at = every_ticks;
  for (auto step = Pipeline::Step::took; step != Pipeline::Step::ended;) {
    step = pipeline.step(outbox);
    path.add(outbox);
    if (command && pipeline.emitted_until_tick() > at) {
      command(pipeline, outbox, at);
      path.add(outbox);
      at = pipeline.emitted_until_tick() + every_ticks;
    }
  }
  EXPECT_FALSE(pipeline.check().fault());
  return path;
}

void hold(Pipeline& pipeline, lookahead::Outbox& outbox, std::int64_t tick) {
  if (pipeline.hold({.tick = tick}, outbox)) {
    pipeline.settle(true);
    pipeline.resume();
  }
}

void slow_down(Pipeline& pipeline, lookahead::Outbox& outbox, std::int64_t tick) {
  const double feed = tick % 2 == 0 ? 0.4 : 1.7;
  if (pipeline.change_plan({.by = {.feed = feed}, .tick = tick, .until_tick = tick + 100},
                           outbox)) {
    pipeline.settle(true);
  }
}

TEST(Path, IsTheSameToTheLastBitWithHoldsAndOverridesAndWithout) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const Path alone = path_under(kind, 1, {});
    ASSERT_GT(alone.stretches.size(), 10U);
    for (const std::int64_t every : {43, 130, 401}) {
      for (const PipelineCommand& command : {PipelineCommand(hold), PipelineCommand(slow_down)}) {
        SCOPED_TRACE(std::string(name_of(kind)) + ", every " + std::to_string(every));
        const Path under = path_under(kind, every, command);
        EXPECT_GT(under.plans, 3U);
        EXPECT_EQ(under.stretches, alone.stretches);
        EXPECT_EQ(under.begins_mm, alone.begins_mm);
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
