// Planning cost: moves to motion, without the parser and without ticks.
#include <cmath>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "lookahead/path/block_builder.hpp"
#include "lookahead/planner.hpp"

namespace kerf::bench {
namespace {

using lookahead::Planner;

lookahead::PlanLimits table_limits() {
  lookahead::PlanLimits limits;
  limits.axes.fill({.velocity_mm_s = 250.0, .acceleration_mm_s2 = 2500.0, .jerk_mm_s3 = 50'000.0});
  limits.chord_tolerance_mm = 1e-3;
  return limits;
}

// A finishing pass over a wavy surface in steps of half a millimetre.
std::vector<parser::Point> wavy_path(std::int64_t blocks) {
  std::vector<parser::Point> points;
  for (std::int64_t i = 0; i <= blocks; ++i) {
    const double s = 0.5 * static_cast<double>(i);
    points.push_back({s, 20.0 * std::sin(s / 17.0), 3.0 * std::sin(s / 5.0)});
  }
  return points;
}

void plan_lines(benchmark::State& state, profiles::ProfileKind kind) {
  const std::int64_t count = state.range(0);
  const lookahead::PlanLimits limits = table_limits();
  const std::vector<parser::Point> points = wavy_path(count);
  for ([[maybe_unused]] auto _ : state) {
    Planner planner({.limits = limits, .profile = profiles::Profile(kind)});
    parser::Move move;
    move.feedrate_mm_s = 100.0;
    lookahead::Outbox outbox;
    std::vector<lookahead::Block> blocks;
    const auto plan_to_rest = [&] {
      while (planner.emit(outbox)) {
        outbox.clear();
      }
    };
    for (std::int64_t i = 0; i < count; ++i) {
      if (!planner.wants_block()) {
        plan_to_rest();
      }
      blocks.clear();
      const auto k = static_cast<std::size_t>(i);
      move.source.line = static_cast<std::uint32_t>(i);
      move.start_mm = points[k];
      move.shape = parser::LineMove{points[k + 1]};
      if (!lookahead::append_blocks(move, limits, blocks)) {
        state.SkipWithError("a move was refused");
        return;
      }
      planner.push(std::move(blocks.front()));
    }
    plan_to_rest();
    planner.finish(0);
    plan_to_rest();
    benchmark::DoNotOptimize(planner.totals().ticks);
  }
  state.SetItemsProcessed(state.iterations() * count);
}

void plan_lines_s_curve(benchmark::State& state) {
  plan_lines(state, profiles::ProfileKind::s_curve);
}
void plan_lines_trapezoid(benchmark::State& state) {
  plan_lines(state, profiles::ProfileKind::trapezoid);
}

BENCHMARK(plan_lines_s_curve)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(plan_lines_trapezoid)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kerf::bench
