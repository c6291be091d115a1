// Records after the tick: what is too slow loses rows, and says how many.
#include "programs/kerf/run/recorder.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "programs/kerf/run/flight_recorder.hpp"
#include "tests/program/temporary_folder.hpp"

namespace kerf::program {
namespace {

TickRecord record_at(std::int64_t tick) {
  return {.tick = tick, .position_mm = {0.5 * static_cast<double>(tick), 0.0, 0.0}};
}

std::int64_t lines_in(const std::string& path) {
  std::ifstream file(path);
  return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
}

// Row 72: the tick never waits for the trace.
TEST(RecorderThreads, Row72DropAndCountWhatATraceIsTooSlowFor) {
  const TemporaryFolder folder;
  constexpr std::int64_t kPushed = 500'000;  // at once: far faster than they can be written
  Recorder recorder;
  recorder.trace.emplace(TraceWriter::create(folder / "t.csv", {}).value());
  RecorderThread thread(recorder, true);
  for (std::int64_t tick = 0; tick < kPushed; ++tick) {
    thread.push(record_at(tick));
  }
  thread.finish();
  EXPECT_GT(thread.dropped(), 0U);
  recorder.trace->close(true);
  EXPECT_EQ(recorder.trace->remains().empty(), false);  // what is not whole says so by its name
  EXPECT_EQ(lines_in(folder / "t.csv.incomplete"),
            1 + kPushed - static_cast<std::int64_t>(thread.dropped()));
}

TEST(FlightRecorders, KeepTheLastFiveSeconds) {
  FlightRecorder flight(0.001);
  for (std::int64_t tick = 0; tick < 12'345; ++tick) {
    flight.add(record_at(tick));
  }
  const auto ticks = flight.ticks();
  ASSERT_EQ(ticks.size(), 5000U);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    EXPECT_EQ(ticks[i].tick, static_cast<std::int64_t>(7345 + i));
  }
}

TEST(FlightRecorders, HaveAllOfAShortRunAndNothingWhereTheyAreNotWanted) {
  FlightRecorder flight(0.001);
  FlightRecorder none(std::numeric_limits<double>::infinity());
  for (std::int64_t tick = 0; tick < 3; ++tick) {
    flight.add(record_at(tick));
    none.add(record_at(tick));
  }
  EXPECT_EQ(flight.ticks().size(), 3U);
  EXPECT_EQ(flight.ticks().front().tick, 0);
  EXPECT_TRUE(none.ticks().empty());
}

TEST(FlightRecorders, SayWhyTheyCannotBeWritten) {
  FlightRecorder flight(0.001);
  flight.add(record_at(1));
  EXPECT_TRUE(flight.write({.path = "/nowhere/at.all"}));
  const TemporaryFolder folder;
  EXPECT_EQ(flight.write({.path = folder / "f.csv"}), std::nullopt);
  EXPECT_EQ(lines_in(folder / "f.csv"), 2);
}

}  // namespace
}  // namespace kerf::program
