// G38.2 at random places, in random directions and at random speeds, against closed forms.
#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

constexpr int kPlaces = 200;
constexpr unsigned kSeed = 20261124;
constexpr double kPeriod_s = 0.001;
// A count of the encoder, and the way in which a lag may change within a tick.
constexpr double kReading_mm = 2e-3;

struct Touch {
  Position from_mm{};
  Position to_mm{};
  double feedrate_mm_s = 0.0;
};

std::string words(const Position& at) {
  std::ostringstream text;
  text << std::fixed << 'X' << at[0] << " Y" << at[1] << " Z" << at[2] << '\n';
  return text.str();
}

std::string program_of(const Touch& touch) {
  return "G21 G61 G90 G54 G94 F" + std::to_string(60.0 * touch.feedrate_mm_s) + "\nG0 " +
         words(touch.from_mm) + "G38.2 " + words(touch.to_mm) + "G0 X#5061 Y#5062 Z#5063\nM2\n";
}

double distance(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// How far from v to rest with the lowest jerk that the limits leave, at the most: from the highest
// acceleration on, as where the trip comes while the probe still accelerates.
double longest_stop_mm(double v, const MachineLimits& limits) {
  const double a = limits.path.acceleration_mm_s2;
  const double j = limits.path.jerk_mm_s3;
  const double turn_s = a / j;  // until it no longer accelerates
  const double fastest = v + 0.5 * a * turn_s;
  return fastest * (2.0 * turn_s) + 0.5 * fastest * fastest / a + 0.5 * fastest * a / j;
}

class RandomContacts : public testing::TestWithParam<bool> {
 protected:
  // depth_mm: how far a place lies within the surface, in closed form.
  template <typename Depth, typename Draw>
  void expect_contacts(const TouchSurface& surface, const Depth& depth_mm, const Draw& draw) {
    const bool latches = GetParam();
    const MachineSettings settings = touching(surface, latches);
    std::mt19937 random(kSeed);
    for (int i = 0; i < kPlaces; ++i) {
      Touch touch = draw(random);
      touch.feedrate_mm_s = std::exp(std::uniform_real_distribution(0.0, std::log(60.0))(random));
      SCOPED_TRACE(std::to_string(kSeed) + ", place " + std::to_string(i) + ": " +
                   program_of(touch));
      ASSERT_LT(depth_mm(touch.from_mm), 0.0);
      ASSERT_GT(depth_mm(touch.to_mm), 0.0);
      KernelOptions options;
      options.profile = i % 4 == 0 ? ProfileChoice{} : ProfileChoice{.kind = ProfileKind::s_curve};
      const TableRun run = whole_run(settings, program_of(touch), {.options = options});
      const Position trip_mm = run.ticks.back().position_mm;
      const double allowed_mm = latches ? 1e-6 : touch.feedrate_mm_s * kPeriod_s + kReading_mm;
      EXPECT_LE(std::abs(depth_mm(trip_mm)), allowed_mm);
      double farthest_mm = 0.0;
      for (const Setpoint& tick : run.ticks) {
        farthest_mm =
            std::max(farthest_mm, tick.line == 3 ? distance(tick.position_mm, touch.from_mm) : 0.0);
      }
      EXPECT_LE(farthest_mm, distance(trip_mm, touch.from_mm) +
                                 longest_stop_mm(touch.feedrate_mm_s, settings.limits) + 1.0);
      if (HasFailure()) {
        return;
      }
    }
  }

  static double between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  }
};

TEST_P(RandomContacts, OfATiltedPlaneAreOnIt) {
  const TouchPlane plane{.point_mm = {10.0, -5.0, -20.0}, .normal = {0.3, -0.2, 1.0}};
  const double length = std::hypot(0.3, -0.2, 1.0);
  const auto depth = [&](const Position& p) {
    return -((p[0] - 10.0) * 0.3 + (p[1] + 5.0) * -0.2 + (p[2] + 20.0)) / length;
  };
  expect_contacts(plane, depth, [](std::mt19937& random) {
    return Touch{.from_mm = {between(random, -40, 40), between(random, -40, 40), 30.0},
                 .to_mm = {between(random, -40, 40), between(random, -40, 40), -80.0}};
  });
}

TEST_P(RandomContacts, OfASphereAreOnIt) {
  const TouchSphere sphere{.centre_mm = {5.0, 8.0, -30.0}, .radius_mm = 25.0};
  const auto depth = [](const Position& p) {
    return 25.0 - std::hypot(p[0] - 5.0, p[1] - 8.0, p[2] + 30.0);
  };
  expect_contacts(sphere, depth, [](std::mt19937& random) {
    const double turn = between(random, 0.0, 6.28);
    const double tilt = between(random, -1.2, 1.2);
    const double far = between(random, 30.0, 60.0);
    return Touch{
        .from_mm = {5.0 + far * std::cos(turn) * std::cos(tilt),
                    8.0 + far * std::sin(turn) * std::cos(tilt), -30.0 + far * std::sin(tilt)},
        .to_mm = {5.0 + between(random, -8, 8), 8.0 + between(random, -8, 8),
                  -30.0 + between(random, -8, 8)}};
  });
}

// z = -10 + x y / 400 - x / 8: a bilinear map gives it back exactly.
TEST_P(RandomContacts, OfAHeightMapAreOnIt) {
  const auto height = [](double x, double y) { return -10.0 + x * y / 400.0 - x / 8.0; };
  HeightMap map{.origin_mm = {-60.0, -50.0}, .spacing_mm = {7.5, 10.0}, .columns = 17};
  for (int row = 0; row < 11; ++row) {
    for (int column = 0; column < 17; ++column) {
      map.heights_mm.push_back(height(-60.0 + 7.5 * column, -50.0 + 10.0 * row));
    }
  }
  // Along z, of which no distance to the surface is larger.
  const auto depth = [&](const Position& p) { return height(p[0], p[1]) - p[2]; };
  expect_contacts(map, depth, [](std::mt19937& random) {
    const double x = between(random, -50, 50);
    const double y = between(random, -40, 40);
    return Touch{.from_mm = {x, y, 25.0},
                 .to_mm = {x + between(random, -5, 5), y + between(random, -5, 5), -60.0}};
  });
}

INSTANTIATE_TEST_SUITE_P(Latching, RandomContacts, testing::Bool(),
                         [](const auto& made) { return made.param ? "latched" : "at_ticks"; });

}  // namespace
}  // namespace kerf::test
