#include "programs/kerf/control/plan_record.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

const std::vector<std::int64_t> kRecordedTicks{
    0, 0, 0, 1, 2, 2, 5, 900, 899, 0, 12'345'678'901, -400, -400, 128, 127};

PlanRecord sample_record() {
  PlanRecord record;
  record.is_attended = true;
  record.emergency_tick = 77;
  for (const std::int64_t tick : kRecordedTicks) {
    record.add_look(tick);
  }
  record.add_order("hold");
  record.add_order("");
  record.add_look(3);
  record.finish();
  return record;
}

void expect_sample(const PlanRecord& record) {
  PlanRecord::Reader reader(record);
  for (const std::int64_t tick : kRecordedTicks) {
    EXPECT_FALSE(reader.order());
    EXPECT_FALSE(reader.take_order());
    EXPECT_FALSE(reader.take_look(tick + 1));
    EXPECT_TRUE(reader.take_look(tick)) << tick;
  }
  EXPECT_FALSE(reader.take_look(kRecordedTicks.back()));
  EXPECT_EQ(reader.order(), "hold");
  EXPECT_EQ(reader.take_order(), "hold");
  EXPECT_EQ(reader.take_order(), "");
  EXPECT_TRUE(reader.take_look(3));
  EXPECT_FALSE(reader.take_look(3));
  EXPECT_FALSE(reader.take_order());
}

TEST(PlanRecord, GivesBackLooksAndOrdersInTheirOrder) {
  const auto read = PlanRecord::from_bytes(sample_record().bytes());
  ASSERT_TRUE(read);
  expect_sample(*read);
  EXPECT_TRUE(read->is_attended);
  EXPECT_FALSE(read->waits_for_start);
  EXPECT_EQ(read->emergency_tick, 77);
  EXPECT_EQ(read->bytes(), sample_record().bytes());
}

TEST(PlanRecord, HasNoLookThatWasTakenBack) {
  PlanRecord record;
  record.take_back_look();  // of nothing
  record.add_look(4);
  record.add_look(5);
  record.add_look(5);
  record.take_back_look();
  record.add_look(6);
  record.take_back_look();
  record.add_look(7);
  record.finish();
  PlanRecord::Reader reader(record);
  for (const std::int64_t tick : {4, 5, 7}) {
    EXPECT_TRUE(reader.take_look(tick)) << tick;
  }
}

TEST(PlanRecord, KnowsWhetherAnybodyAskedForAnything) {
  PlanRecord record;
  record.add_look(1);
  EXPECT_FALSE(record.has_orders());
  record.emergency_tick = 3;
  EXPECT_TRUE(record.has_orders());
  EXPECT_TRUE(sample_record().has_orders());
}

// 1,000 periods of a run in which nothing happens.
TEST(PlanRecord, TakesThreeBytesAPeriod) {
  PlanRecord record;
  for (int tick = 0; tick < 1000; ++tick) {
    for (int look = 0; look < 4; ++look) {
      record.add_look(tick);
    }
  }
  EXPECT_LE(record.bytes().size(), 3000U);
}

TEST(PlanRecord, ThatIsCutOffAnywhereEndsThere) {
  const std::string whole = sample_record().bytes();
  EXPECT_FALSE(PlanRecord::from_bytes(""));
  for (std::size_t length = 3; length < whole.size(); ++length) {
    const auto cut = PlanRecord::from_bytes(whole.substr(0, length));
    ASSERT_TRUE(cut);
    PlanRecord::Reader reader(*cut);
    std::size_t looks = 0;
    while (looks < kRecordedTicks.size() && reader.take_look(kRecordedTicks[looks])) {
      ++looks;
    }
    while (reader.take_order()) {
    }
    EXPECT_FALSE(reader.take_order());
  }
}

}  // namespace
}  // namespace kerf::program
