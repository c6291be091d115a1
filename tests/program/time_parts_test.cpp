#include "programs/kerf/report/time_parts.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

// The same as of the page: web/tests/plan_test.ts.
TEST(Headings, AreTheCommentsThatStandAlone) {
  EXPECT_EQ(heading_of("(T1 end mill)"), "T1 end mill");
  EXPECT_EQ(heading_of(" N20 (pocket 1)\t"), "pocket 1");
  EXPECT_EQ(heading_of("n7(contour)"), "contour");
  EXPECT_EQ(heading_of("; contour "), "contour");
  EXPECT_EQ(heading_of("(print it)"), "print it");
  for (const char* none : {"G0 X1 (not this)", "(MSG, hello)", "(print,#1)", "( Debug , x)", "()",
                           "(a)(b)", "(a", "N", "N20", "", ";", "X1"}) {
    EXPECT_EQ(heading_of(none), "") << none;
  }
}

struct Part {
  std::int64_t ticks = 0;
  std::uint32_t line = 1;
  TickKind kind = TickKind::cut;
  std::int32_t tool = 0;
};

TimeParts parts_of(std::vector<Heading> headings, const std::vector<Part>& parts) {
  PartsAccount account(std::move(headings), ToolChange::takes_none);
  TickRecord record;
  for (const Part& part : parts) {
    for (std::int64_t i = 0; i < part.ticks; ++i) {
      const std::int64_t tick = record.tick + 1;
      record = {.tick = tick,
                .line = part.line,
                .rapid = part.kind == TickKind::rapid,
                .tool = part.tool,
                .limit = part.kind == TickKind::rest ? interp::Constraint::rest
                                                     : interp::Constraint::programmed};
      account.add(record);
    }
  }
  ++record.tick;
  account.add(record);
  return account.parts();
}

TEST(TimeParts, GoToTheToolAndTheLastHeadingBefore) {
  const TimeParts parts = parts_of({{.line = 2, .text = "rough"}, {.line = 6, .text = "finish"}},
                                   {{.ticks = 1, .line = 1, .kind = TickKind::rapid},
                                    {.ticks = 20, .line = 3, .tool = 4},
                                    {.ticks = 300, .line = 5, .kind = TickKind::rest, .tool = 4},
                                    {.ticks = 4000, .line = 7, .tool = 4}});
  ASSERT_EQ(parts.tools.size(), 2U);
  EXPECT_EQ(parts.tools[0].name, "no tool");
  EXPECT_EQ(parts.tools[0].time.rapid, 1);
  EXPECT_EQ(parts.tools[1].name, "T4");
  EXPECT_EQ(parts.tools[1].time.cutting, 4020);
  EXPECT_EQ(parts.tools[1].time.rest, 300);
  ASSERT_EQ(parts.operations.size(), 3U);
  EXPECT_EQ(parts.operations[0].ticks(), 1);
  EXPECT_EQ(parts.operations[0].line, 0U);
  EXPECT_EQ(parts.operations[1].name, "rough");
  EXPECT_EQ(parts.operations[1].time.cutting, 20);
  EXPECT_EQ(parts.operations[1].time.rest, 300);
  EXPECT_EQ(parts.operations[2].line, 6U);
  EXPECT_EQ(parts.operations[2].ticks(), 4000);
}

TEST(TimeParts, TakeARestThatAnotherToolFollowsForItsChange) {
  const TimeParts parts = parts_of({}, {{.ticks = 10, .line = 1, .tool = 1},
                                        {.ticks = 50, .line = 2, .kind = TickKind::rest, .tool = 1},
                                        {.ticks = 5, .line = 2, .kind = TickKind::rest, .tool = 2},
                                        {.ticks = 7, .line = 3, .tool = 2}});
  ASSERT_EQ(parts.tools.size(), 2U);
  EXPECT_EQ(parts.tools[0].time.tool_change, 50);
  EXPECT_EQ(parts.tools[1].time.tool_change, 5);
  EXPECT_EQ(parts.tools[1].time.cutting, 7);
  EXPECT_TRUE(parts.operations.empty());
}

}  // namespace
}  // namespace kerf::program
