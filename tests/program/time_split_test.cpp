#include "programs/kerf/report/time_split.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

struct SplitPart {
  std::int64_t ticks = 0;
  TickKind kind = TickKind::cut;
  std::uint32_t line = 1;
  std::int32_t tool = 0;
};

TimeSplit split_of(const std::vector<SplitPart>& parts,
                   ToolChange tool_change = ToolChange::takes_none) {
  TimeAccount account(tool_change);
  std::int64_t tick = 0;
  TickRecord record;
  for (const SplitPart& part : parts) {
    for (std::int64_t i = 0; i < part.ticks; ++i) {
      record = {.tick = tick++,
                .line = part.line,
                .rapid = part.kind == TickKind::rapid,
                .tool = part.tool,
                .limit = part.kind == TickKind::rest ? interp::Constraint::rest
                                                     : interp::Constraint::programmed};
      account.add(record);
    }
  }
  record.tick = tick;  // the end, which begins no period
  account.add(record);
  return account.split();
}

TEST(TimeSplit, CountsWhatTheMachineDoesFromTickToTick) {
  const TimeSplit split = split_of({{.ticks = 3, .kind = TickKind::rapid},
                                    {.ticks = 10},
                                    {.ticks = 5, .kind = TickKind::rest, .line = 2},
                                    {.ticks = 7, .line = 3}});
  EXPECT_EQ(split.cutting, 17);
  EXPECT_EQ(split.rapid, 3);
  EXPECT_EQ(split.rest, 5);
  EXPECT_EQ(split.tool_change, 0);
}

TEST(TimeSplit, CountsTheRapidsBeforeTheFirstCutAsTheApproach) {
  EXPECT_EQ(split_of({{.ticks = 3, .kind = TickKind::rapid},
                      {.ticks = 9, .kind = TickKind::rest, .line = 2},
                      {.ticks = 4, .kind = TickKind::rapid, .line = 3},
                      {.ticks = 10, .line = 4},
                      {.ticks = 50, .kind = TickKind::rapid, .line = 5},
                      {.ticks = 10, .line = 6}})
                .approach,
            7);
  EXPECT_EQ(split_of({{.ticks = 3, .kind = TickKind::rapid}}).approach, 0) << "nothing is cut";
  EXPECT_EQ(split_of({{.ticks = 3}, {.ticks = 5, .kind = TickKind::rapid}, {.ticks = 3}}).approach,
            0);
}

TEST(TimeSplit, CountsAToolChangeThatTakesItsTimeWithTheNewTool) {
  const TimeSplit split = split_of({{.ticks = 10, .tool = 1},
                                    {.ticks = 5, .kind = TickKind::rest, .line = 3, .tool = 2},
                                    {.ticks = 4, .kind = TickKind::rest, .line = 4, .tool = 2},
                                    {.ticks = 1, .line = 5, .tool = 2}},
                                   ToolChange::takes_time);
  EXPECT_EQ(split.tool_change, 5);
  EXPECT_EQ(split.rest, 4);
}

TEST(TimeSplit, CountsADwellBehindAToolChangeThatTakesNoTimeAsARest) {
  const TimeSplit split = split_of({{.ticks = 10, .tool = 1},
                                    {.ticks = 5, .kind = TickKind::rest, .line = 3, .tool = 2},
                                    {.ticks = 1, .line = 4, .tool = 2}});
  EXPECT_EQ(split.rest, 5);
  EXPECT_EQ(split.tool_change, 0);
}

TEST(TimeSplit, TakesTheRestsOfALineThatAnotherToolFollowsForAToolChange) {
  const TimeSplit split = split_of({{.ticks = 10},
                                    {.ticks = 5, .kind = TickKind::rest, .line = 2},
                                    {.ticks = 8, .kind = TickKind::rest, .line = 3},
                                    {.ticks = 2, .kind = TickKind::rest, .line = 3, .tool = 4},
                                    {.ticks = 6, .kind = TickKind::rest, .line = 5, .tool = 4},
                                    {.ticks = 1, .line = 6, .tool = 4}});
  EXPECT_EQ(split.cutting, 11);
  EXPECT_EQ(split.rest, 5 + 6);
  EXPECT_EQ(split.tool_change, 8 + 2);
}

TEST(TimeSplit, OfNoTicksIsNothing) {
  const TimeSplit split = TimeAccount(ToolChange::takes_none).split();
  EXPECT_EQ(split.cutting + split.rapid + split.rest + split.tool_change, 0);
}

}  // namespace
}  // namespace kerf::program
