#include "lookahead/emit/emitted_items.hpp"

#include <deque>

#include <gtest/gtest.h>

#include "profiles/transition.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kPeriod_s = 0.001;

interp::Phase cruise(std::int64_t begin_tick, const interp::Phase& before) {
  constexpr double v_mm_s = 10.0;
  constexpr double length_mm = 0.5;  // 50 ticks
  return {.curve = 1,
          .begin = {.tick = begin_tick},
          .s_begin_mm = before.s_end_mm,
          .s_end_mm = before.s_end_mm + length_mm,
          .law = profiles::Transition::cruise(v_mm_s, length_mm)};
}

// Found by a soak: its end was taken for a place to brake from, a jump of 0.03 mm farther on.
TEST(EmittedItems, APhaseThatAnotherPlanCutsShortHasNoEnd) {
  EmittedItems items(kPeriod_s);
  const EmitPlace begin{};
  items.begin(begin);
  const interp::Phase first = cruise(0, {});
  items.add(first);
  items.add(cruise(50, first));
  const EmittedItems::Ticks all{.begin = 0, .end = 100};
  ASSERT_EQ(items.ends_within(all).size(), 1U);
  EXPECT_EQ(items.ends_within(all).front().curve_mm, 0.5);

  std::deque<Item> ahead;
  const auto motion = items.at(20);
  ASSERT_TRUE(motion);
  items.take_back(*motion, begin, ahead);
  items.add(cruise(20, {.s_end_mm = motion->curve_mm}));
  items.add(cruise(70, {.s_end_mm = motion->curve_mm + 0.5}));
  const auto ends = items.ends_within(all);
  ASSERT_EQ(ends.size(), 1U);
  EXPECT_NEAR(ends.front().curve_mm, 0.7, 1e-12);
  EXPECT_EQ(ends.front().when.tick, 70);
}

}  // namespace
}  // namespace kerf::lookahead::test
