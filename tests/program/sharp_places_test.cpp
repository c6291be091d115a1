#include "programs/kerf/plot/sharp_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

constexpr PaperBox kPaper{.min = {}, .max = {.u_mm = 100.0, .v_mm = 100.0}};

// Ticks of 0.05 mm from corner to corner; each line of the program ends at one.
class Path {
 public:
  void to(double x, double y, bool rapid = false) {
    const double length = std::hypot(x - x_, y - y_);
    const int ticks = std::max(1, static_cast<int>(length / 0.05));
    ++line_;
    for (int i = 1; i <= ticks; ++i) {
      const double share = static_cast<double>(i) / ticks;
      places_.add({x_ + share * (x - x_), y_ + share * (y - y_), 0.0}, line_, rapid);
    }
    x_ = x;
    y_ = y;
  }
  [[nodiscard]] std::vector<SharpPlace> sharpest(std::size_t count) const {
    return places_.sharpest(count);
  }
  void circle(double radius) {
    ++line_;
    const int ticks = static_cast<int>(2.0 * std::numbers::pi * radius / 0.05);
    const double x = x_ - radius;
    for (int i = 1; i <= ticks; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / ticks;
      places_.add({x + radius * std::cos(angle), y_ + radius * std::sin(angle), 0.0}, line_, false);
    }
  }

 private:
  SharpPlaces places_{View::top, kPaper};
  double x_ = 0.0;
  double y_ = 0.0;
  std::uint32_t line_ = 0;
};

TEST(SharpPlaces, AreTheCornersThatTurnMost) {
  Path path;
  path.to(90.0, 0.0);
  path.to(90.0, 50.0);  // 90 degrees
  path.to(50.0, 50.0);  // 90
  path.to(90.0, 60.0);  // 166
  path.to(90.0, 95.0);  // 76
  const auto places = path.sharpest(2);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NEAR(places[0].turn_rad, 2.90, 0.02);
  EXPECT_NEAR(places[0].at.u_mm, 50.0, 1.0);
  EXPECT_NEAR(places[0].at.v_mm, 50.0, 1.0);
  EXPECT_NEAR(places[1].turn_rad, std::numbers::pi / 2.0, 0.02);
  for (const SharpPlace& place : path.sharpest(99)) {
    EXPECT_TRUE(std::set<std::uint32_t>({1, 2, 3, 4, 5}).contains(place.line)) << place.line;
  }
}

TEST(SharpPlaces, NameTheLineThatLeadsIntoTheCornerOrOutOfIt) {
  Path path;
  path.to(60.0, 0.0);
  path.to(60.0, 60.0);
  const auto places = path.sharpest(9);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_TRUE(places[0].line == 1 || places[0].line == 2) << places[0].line;
}

TEST(SharpPlaces, AreNoneOnALineOrAWideCircle) {
  Path line;
  line.to(100.0, 100.0);
  EXPECT_TRUE(line.sharpest(9).empty());
  Path circle;
  circle.to(90.0, 40.0);
  circle.to(90.0, 50.0);
  Path wide;
  wide.circle(40.0);
  EXPECT_TRUE(wide.sharpest(9).empty());
}

TEST(SharpPlaces, KeepAwayFromEachOther) {
  Path path;
  for (int i = 0; i < 400; ++i) {
    path.to(i % 2 == 0 ? 100.0 : 0.0, 0.25 * i);
    path.to(i % 2 == 0 ? 100.0 : 0.0, 0.25 * (i + 1));
  }
  const auto places = path.sharpest(8);
  ASSERT_EQ(places.size(), 8U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GT(
          std::hypot(places[i].at.u_mm - places[k].at.u_mm, places[i].at.v_mm - places[k].at.v_mm),
          8.0);
    }
  }
}

TEST(SharpPlaces, DoNotCountRapids) {
  Path path;
  path.to(50.0, 0.0);
  path.to(50.0, 50.0, true);
  path.to(0.0, 50.0);
  EXPECT_TRUE(path.sharpest(9).empty());
}

}  // namespace
}  // namespace kerf::program
