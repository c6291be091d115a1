// Ticks around a valley of the limit curve: the mean feedrate of one is above the lowest by what
// its acceleration changes, which may be many times what the chord allows there.
#include <algorithm>

#include <gtest/gtest.h>

#include "lookahead/path/feed_scan.hpp"
#include "tests/lookahead/blocks.hpp"
#include "tests/lookahead/chords.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kTolerance_mm = 1e-4;
constexpr int kSteps = 400;  // of a tick

struct Fold {
  double size_mm = 0.0;
  double weight = 1.0;
};

// Forward, back by size_mm, and forward again, in sharp turns.
curves::NurbsData fold(const Fold& of) {
  return {.degree = 3,
          .points = {{{-1, 0, 0}, 1.0},
                     {{0, 0, 0}, of.weight},
                     {{-of.size_mm, of.size_mm, 0}, of.weight},
                     {{1, of.size_mm, 0}, 1.0}},
          .knots = {0, 0, 0, 0, 1, 1, 1, 1}};
}

// Where a tick ends that begins there and is nowhere slower than the limit curve.
double end_of_tick_mm(const VelocityLimitCurve& limit_curve, double s_mm) {
  for (int i = 0; i < kSteps; ++i) {
    s_mm += feedrate_at_mm_s(limit_curve, s_mm) * kTs / kSteps;
  }
  return std::min(s_mm, limit_curve.back().s_mm);
}

// The law of a machine that is as strong as that comes as close to the limit curve as one likes.
TEST(ValleyTicks, KeepTheChordThoughAllOfThemIsRunAtTheLimitCurve) {
  for (const curves::NurbsData& data :
       {fold({2e-4, 1e3}), fold({5e-4, 1e3}), fold({1e-3, 1e3}), fold({2e-4, 1e5})}) {
    const curves::NurbsCurve curve = smooth_curve(data);
    for (const ScanFor plan : {ScanFor::trapezoid, ScanFor::bounded_jerk, ScanFor::time_optimum}) {
      const VelocityLimitCurve limit_curve =
          scan_feedrate(curve, {.feedrate_mm_s = 100.0,
                                .along = {.acceleration_mm_s2 = 1e7, .jerk_mm_s3 = 1e12},
                                .period_s = kTs,
                                .chord_tolerance_mm = kTolerance_mm,
                                .plan = plan});
      double worst = 0.0;
      for (double s = 0.0; s < curve.length_mm();) {
        const double end = end_of_tick_mm(limit_curve, s);
        worst = std::max(worst, chord_error_mm(curve, s, end));
        s += 0.07 * kTs * feedrate_at_mm_s(limit_curve, s);
      }
      EXPECT_LE(worst, 1.001 * kTolerance_mm) << data.points[2].position_mm[0];
      EXPECT_GE(worst, 0.2 * kTolerance_mm) << "slower than it must be";
    }
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
