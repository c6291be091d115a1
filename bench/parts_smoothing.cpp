#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>

#include "bench/part_programs.hpp"
#include "bench/parts.hpp"
#include "smoothing/smoother.hpp"

namespace kerf::bench {

namespace {

constexpr double kMinBlocks_per_s = 300'000.0;
constexpr int kBatch = 1000;

struct Rate {
  std::int64_t blocks = 0;
  double smoothing_s = 0.0;
  std::int64_t parts = 0;
};

// Moves through these points, made in batches outside the clock.
Rate smooth(std::int64_t blocks, const std::function<Point()>& next) {
  smoothing::Smoother smoother({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 50000.0});
  Rate rate{.blocks = blocks};
  Point at = next();
  std::vector<parser::Move> batch(kBatch);
  std::clock_t spent = 0;  // of the processor: the machine may be busy
  smoothing::Smoother::Output output;
  for (std::int64_t done = 0; done < blocks; done += kBatch) {
    for (parser::Move& move : batch) {
      move = {};
      move.start_mm = at;
      at = next();
      move.shape = parser::LineMove{at};
      move.feedrate_mm_s = 100.0;
      move.mode = parser::PathMode::blend;
      move.blend_tolerance_mm = move.merge_tolerance_mm = 0.01;
    }
    const std::clock_t began = std::clock();
    for (const parser::Move& move : batch) {
      if (!smoother.push(move)) {
        return {};
      }
      while (smoother.next(output)) {
        ++rate.parts;
      }
    }
    spent += std::clock() - began;
  }
  rate.smoothing_s = static_cast<double>(spent) / CLOCKS_PER_SEC;
  return rate;
}

bool print_row(const char* name, const Rate& rate) {
  const double per_s = static_cast<double>(rate.blocks) / rate.smoothing_s;
  const bool met = per_s >= kMinBlocks_per_s;
  std::printf("| %s | %lld | %lld | %.2f | %.0f | %s |\n", name,
              static_cast<long long>(rate.blocks), static_cast<long long>(rate.parts),
              rate.smoothing_s, per_s, met ? "met" : "MISSED");
  std::fflush(stdout);
  return met;
}

}  // namespace

bool parts_smoothing(const PartsOrder& order) {
  if (!order.only.empty() && order.only != "cost") {
    return true;
  }
  const std::int64_t blocks = order.quick ? 100'000 : 1'000'000;
  std::printf(
      "Smoothing alone, P 0.01 and Q 0.01, moves to path parts; target: %.0f blocks a second of "
      "one core.\n\n"
      "| lines | blocks | parts | time [s] | blocks/s | |\n| --- | --- | --- | --- | --- | --- |\n",
      kMinBlocks_per_s);
  Flower flower(0.1);
  const auto petals = [&flower] {
    flower.advance();
    return flower.here();
  };
  bool met = print_row("flower, 0.1 mm", smooth(blocks, petals));
  // A right angle at every point.
  std::int64_t step = 0;
  const auto stairs = [&step] {
    ++step;
    const std::int64_t along_x = step / 2;
    return Point{static_cast<double>(along_x), static_cast<double>(step - along_x), 0.0};
  };
  met = print_row("stairs of 1 mm, a blend at each", smooth(blocks, stairs)) && met;
  // Left and right in turn by 20 to 150 degrees, never the same.
  Point here{};
  double heading = 0.0;
  const auto turns = [&] {
    constexpr double kGolden = 0.6180339887498949;
    const double turn = 0.35 + 2.27 * std::fmod(kGolden * static_cast<double>(step), 1.0);
    heading += step % 2 == 0 ? turn : -turn;
    here[0] += std::cos(heading);
    here[1] += std::sin(heading);
    ++step;
    return here;
  };
  met = print_row("turns of 20 to 150 degrees, a blend at each", smooth(blocks, turns)) && met;
  std::printf("\n");
  return met;
}

}  // namespace kerf::bench
