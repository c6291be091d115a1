#include "programs/kerf/page/tick_columns.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TickRecord row_at(std::int64_t tick) {
  const double t = 1e-3 * static_cast<double>(tick);
  return {.tick = tick,
          .limit = tick % 8 < 5 ? Constraint::programmed : Constraint::path_jerk,
          .motion = {.v_mm_s = tick == 777 ? 99.0 : 10.0, .a_mm_s2 = tick == 778 ? -7.0 : 0.0},
          .position_mm = {t * t * t, 2.0 * t, 0.0},
          .actual_mm = {t * t * t, 2.0 * t + 0.003, 0.004},
          .detail = {.deviation_mm = t}};
}

TEST(TickColumns, AreTheTicksThemselvesWhileTheyLast) {
  TickColumns columns({.period_s = 1e-3});
  for (std::int64_t tick = 0; tick < 100; ++tick) {
    columns.add(row_at(tick));
  }
  ASSERT_EQ(columns.series().size(), 3U + 3U * 3U + 2U);
  EXPECT_EQ(columns.ticks_per_column(), 1);
  EXPECT_EQ(columns.columns(), 100U);
  EXPECT_TRUE(columns.series()[0].max.empty());
  // x = t^3: its third derivative is 6 everywhere, y = 2 t has the first derivative 2. The first
  // three differences reach back before the first tick.
  for (std::size_t i = 3; i < 100; ++i) {
    EXPECT_NEAR(columns.series()[5].min[i], 6.0F, 0.01F) << i;
    EXPECT_NEAR(columns.series()[6].min[i], 2.0F, 1e-4F) << i;
    EXPECT_NEAR(columns.series()[12].min[i], 0.005F, 1e-6F) << i;
    EXPECT_NEAR(columns.series()[13].min[i], 0.001 * static_cast<double>(i), 1e-6) << i;
  }
}

TEST(TickColumns, MergeWithoutLosingAPeak) {
  TickColumns columns({.period_s = 1e-3, .max_columns = 64});
  for (std::int64_t tick = 0; tick < 1000; ++tick) {
    columns.add(row_at(tick));
  }
  EXPECT_EQ(columns.ticks_per_column(), 16);
  EXPECT_EQ(columns.columns(), 63U);
  const ColumnSeries& v = columns.series()[0];
  const ColumnSeries& a = columns.series()[1];
  for (std::size_t i = 0; i < columns.columns(); ++i) {
    EXPECT_EQ(v.max[i], i == 777 / 16 ? 99.0F : 10.0F);
    EXPECT_EQ(v.min[i], 10.0F);
    EXPECT_EQ(a.min[i], i == 778 / 16 ? -7.0F : 0.0F);
  }
  for (const std::uint8_t limit : columns.limits()) {
    EXPECT_EQ(limit, static_cast<std::uint8_t>(Constraint::programmed)) << "5 of 8 ticks";
  }
}

TEST(TickColumns, OfAWindowAreThoseOfTheWholeRunThere) {
  TickColumns all({.period_s = 1e-3});
  TickColumns part({.period_s = 1e-3, .window = {.first = 700, .last = 899}});
  for (std::int64_t tick = 0; tick < 1000; ++tick) {
    EXPECT_EQ(part.has_all(), tick > 899) << tick;
    all.add(row_at(tick));
    part.add(row_at(tick));
  }
  EXPECT_EQ(part.first_tick(), 700);
  EXPECT_EQ(part.ticks_per_column(), 1);
  ASSERT_EQ(part.columns(), 200U);
  for (std::size_t series = 0; series < all.series().size(); ++series) {
    const auto& whole = all.series()[series].min;
    EXPECT_EQ(part.series()[series].min, std::vector(whole.begin() + 700, whole.begin() + 900));
    EXPECT_TRUE(part.series()[series].max.empty());
  }
  const std::vector<std::uint8_t> limits = all.limits();
  EXPECT_EQ(part.limits(), std::vector(limits.begin() + 700, limits.begin() + 900));
}

TEST(TickColumns, HaveTheOtherAxesOfTheMachineInTheirUnits) {
  TickColumns columns({.period_s = 0.5, .extra = extra_axes(parser::letter_bit('A'))});
  columns.add({.tick = 0});
  columns.add({.tick = 1, .extra_rad_mm = {3.14159265358979 / 2.0}});
  ASSERT_EQ(columns.series().size(), 3U + 3U * 4U + 2U);
  EXPECT_NEAR(columns.series()[12].min[1], 180.0F, 1e-4F) << "90 degrees in half a second";
}

}  // namespace
}  // namespace kerf::program
