#include "bench/streaming.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <utility>
#include <variant>
#include <vector>

#include "bench/curve_run.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/planner.hpp"

namespace kerf::bench {

using lookahead::Block;

namespace {

constexpr double kOfOneWindow = 1.02;
constexpr std::size_t kEverything = std::numeric_limits<std::size_t>::max() / 2;
constexpr std::size_t kWindowBlocks = 200;
constexpr double kFeedrate_mm_s = 100.0;

// The next move of a path; false: it has ended.
using Moves = std::function<bool(parser::Move&)>;

struct Window {
  std::size_t blocks = kEverything;
  std::size_t cells = kEverything;
};

Window streaming_window() {
  return {.blocks = kWindowBlocks, .cells = lookahead::PlannerSettings{}.window_cells};
}

struct Streamed {
  double time_s = 0.0;
  double planning_s = 0.0;
  std::size_t cells = 0;
  std::size_t degradations = 0;
};

// Motion is thrown away as it comes, so only what the planner keeps is held.
Streamed stream(const Moves& next, const lookahead::PlanLimits& limits, const Window& window) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  lookahead::Planner planner({.limits = limits,
                              .profile = profiles::Profile(profiles::ProfileKind::time_optimal),
                              .window_blocks = window.blocks,
                              .window_cells = window.cells});
  lookahead::Outbox outbox;
  const auto emit = [&] {
    while (planner.emit(outbox)) {
      outbox.clear();
    }
  };
  std::vector<Block> blocks;
  for (parser::Move move; next(move);) {
    blocks.clear();
    if (!lookahead::append_blocks(move, limits, blocks, planner.scan_for())) {
      throw std::runtime_error("a move was refused");
    }
    for (Block& block : blocks) {
      if (!planner.wants_block()) {
        emit();
      }
      planner.push(std::move(block));
    }
  }
  planner.finish(0);
  emit();
  const std::chrono::duration<double> planning = Clock::now() - began;
  const PlanTotals& totals = planner.totals();
  return {.time_s = static_cast<double>(totals.ticks) * limits.period_s,
          .planning_s = planning.count(),
          .cells = totals.segments,
          .degradations = totals.degradations.count};
}

// Bends between radii of some millimetres and nearly straight.
parser::Point waypoint(int i) {
  const double x = i;
  return {1.5 * x, 6.0 * std::sin(0.31 * x) + 3.0 * std::sin(1.13 * x), std::cos(0.23 * x)};
}

parser::Point sum(double share_a, const parser::Point& a, double share_b, const parser::Point& b) {
  return {share_a * a[0] + share_b * b[0], share_a * a[1] + share_b * b[1],
          share_a * a[2] + share_b * b[2]};
}

parser::Move curve_move(parser::NurbsMove curve) {
  parser::Move move;
  move.start_mm = curve.points.front().position_mm;
  move.feedrate_mm_s = kFeedrate_mm_s;
  curve.point_lines.assign(curve.points.size(), 1);
  curve.knot_lines.assign(curve.knots.size(), 1);
  move.shape = std::move(curve);
  return move;
}

// The pieces of a uniform cubic B-spline, each a curve of its own: they join with one curvature.
Moves short_curves(int count) {
  return [count, i = 0](parser::Move& move) mutable {
    if (i == count) {
      return false;
    }
    const parser::Point before = sum(1.0 / 3, waypoint(i), 2.0 / 3, waypoint(i + 1));
    const parser::Point second = sum(2.0 / 3, waypoint(i + 1), 1.0 / 3, waypoint(i + 2));
    const parser::Point third = sum(1.0 / 3, waypoint(i + 1), 2.0 / 3, waypoint(i + 2));
    const parser::Point behind = sum(2.0 / 3, waypoint(i + 2), 1.0 / 3, waypoint(i + 3));
    ++i;
    move = curve_move({.degree = 3,
                       .points = {{.position_mm = sum(0.5, before, 0.5, second)},
                                  {.position_mm = second},
                                  {.position_mm = third},
                                  {.position_mm = sum(0.5, third, 0.5, behind)}},
                       .knots = {0, 0, 0, 0, 1, 1, 1, 1},
                       .point_lines = {},
                       .knot_lines = {}});
    return true;
  };
}

struct LongCurve {
  int degree = 3;
  int points = 1000;
};

Moves one_curve(const LongCurve& of) {
  return [of, done = false](parser::Move& move) mutable {
    if (std::exchange(done, true)) {
      return false;
    }
    parser::NurbsMove curve{
        .degree = of.degree, .points = {}, .knots = {}, .point_lines = {}, .knot_lines = {}};
    curve.knots.assign(static_cast<std::size_t>(of.degree), 0);
    for (int i = 0; i < of.points; ++i) {
      curve.points.push_back({.position_mm = waypoint(i)});
    }
    const int spans = of.points - of.degree;
    for (int i = 0; i <= spans; ++i) {
      curve.knots.push_back(i);
    }
    curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(of.degree), spans);
    move = curve_move(std::move(curve));
    return true;
  };
}

// Without the events.
Moves shipped(const std::string& program) {
  return [moves = moves_of(program), i = std::size_t{0}](parser::Move& move) mutable {
    while (i < moves.size() && (std::holds_alternative<parser::EventMove>(moves[i].shape) ||
                                std::holds_alternative<parser::DwellMove>(moves[i].shape))) {
      ++i;
    }
    if (i == moves.size()) {
      return false;
    }
    move = moves[i++];
    return true;
  };
}

struct Path {
  std::string name;
  std::function<Moves()> moves;
  Window window;
  std::size_t part = 0;  // of all cells that the window has, if it is no fixed number
};

bool print_row(const Path& path, const lookahead::PlanLimits& limits) {
  const Streamed whole = stream(path.moves(), limits, {});
  Window window = path.window;
  if (path.part > 0) {
    window.cells = whole.cells / path.part;
  }
  const Streamed cut = stream(path.moves(), limits, window);
  const double ratio = cut.time_s / whole.time_s;
  const bool met = ratio <= kOfOneWindow && cut.degradations == 0;
  std::printf("| %s | %s | %zu | %zu | %.3f | %.3f | %.4f | %.2f | %.2f | %zu, %zu | %s |\n",
              path.name.c_str(),
              window.blocks == kEverything ? "all" : std::to_string(window.blocks).c_str(),
              window.cells, whole.cells, cut.time_s, whole.time_s, ratio, cut.planning_s,
              whole.planning_s, cut.degradations, whole.degradations, met ? "met" : "MISSED");
  std::fflush(stdout);
  return met;
}

long peak_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-union-access): a member of rusage is one.
  return usage.ru_maxrss;
}

// The peak of a process never falls, so the short path comes first.
bool memory_holds(const lookahead::PlanLimits& limits) {
  constexpr double kMaxGrowth = 1.1;
  std::printf("| short curves | peak memory [KiB] |\n| --- | --- |\n");
  long first = 0;
  long last = 0;
  for (const int count : {1000, 4000}) {
    stream(short_curves(count), limits, streaming_window());
    last = peak_kib();
    first = first == 0 ? last : first;
    std::printf("| %d | %ld |\n", count, last);
  }
  return static_cast<double>(last) <= kMaxGrowth * static_cast<double>(first);
}

}  // namespace

int streaming() {
  const lookahead::PlanLimits limits = machine("table.toml").limits;
  bool met = memory_holds(limits);
  std::printf(
      "\n| path | window [blocks] | window [cells] | cells | time [s] | time in one window [s] | "
      "ratio | planning [s] | in one window [s] | degradations | at most %.2f, none |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      kOfOneWindow);
  std::vector<Path> paths{
      {"500 short cubic curves", [] { return short_curves(500); }, streaming_window()},
      {"raster", [] { return shipped("raster.ngc"); }, streaming_window()}};
  for (const int degree : {2, 3, 4, 5, 7}) {
    paths.push_back({"NURBS of 1000 points, degree " + std::to_string(degree),
                     [degree] { return one_curve({.degree = degree}); },
                     {},
                     10});
  }
  for (const Path& path : paths) {
    met = print_row(path, limits) && met;
  }
  return met ? 0 : 1;
}

}  // namespace kerf::bench
