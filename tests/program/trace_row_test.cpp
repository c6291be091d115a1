#include "programs/kerf/run/trace_row.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "programs/kerf/report/constraint_text.hpp"

namespace kerf::program {
namespace {

std::string row_of(const TickRecord& record, double period_s) {
  std::array<char, kMaxRowBytes> buffer{};
  char* const end = write_row(buffer.data(), record, TickClock(period_s));
  return {buffer.data(), end};
}

std::string time_of(std::int64_t tick, double period_s) {
  std::array<char, kMaxRowBytes> buffer{};
  char* const end = TickClock(period_s).write(buffer.data(), tick);
  return {buffer.data(), end};
}

TEST(TraceRow, HasTheColumnsOfTheHeaderWithTheirDecimals) {
  const TickRecord record{
      .tick = 1234,
      .line = 56,
      .motion = {.s_mm = 1.5, .v_mm_s = 100.0, .a_mm_s2 = -2500.25, .j_mm_s3 = 5e4},
      .position_mm = {1.0 / 3.0, -2.0, 0.0},
      .actual_mm = {0.3333, -1.999, 1e-10}};
  EXPECT_EQ(row_of(record, 0.001),
            "1.234000,56,1.5000000000,100.000000,-2500.250000,50000.000000,"
            "0.3333333333,-2.0000000000,0.0000000000,0.3333000000,-1.9990000000,0.0000000001,,0."
            "0000000000\n");
  const std::string row = row_of(record, 0.001);
  EXPECT_EQ(std::count(row.begin(), row.end(), ','),
            std::count(kTraceHeader.begin(), kTraceHeader.end(), ','));
}

TEST(TraceRow, HasTheLimitAtItsEndWhereItIsAskedFor) {
  EXPECT_TRUE(trace_header({.axes = {}, .limit = true}).ends_with("chord_error_mm,limit\n"));
  const TickRecord record{.limit = Constraint::x_jerk};
  std::array<char, kMaxRowBytes> buffer{};
  const std::string row(buffer.data(), write_row(buffer.data(), record, TickClock(0.001),
                                                 {.axes = {}, .limit = true}));
  EXPECT_TRUE(row.ends_with(",,0.0000000000,axis_x_jerk\n"));
}

TEST(TraceRow, HasColumnsOfFurtherAxesBehindTheOthers) {
  const auto axes = extra_axes(parser::letters('A', 'U'));
  EXPECT_EQ(trace_header({}), kTraceHeader);
  const std::string plain(kTraceHeader.substr(0, kTraceHeader.size() - 1));
  EXPECT_EQ(trace_header({.axes = axes}), plain + ",a_deg,u_mm\n");
  const TickRecord record{.extra_rad_mm = {3.14159265358979323846 / 2, 1, 1, -2.5, 1, 1}};
  std::array<char, kMaxRowBytes> buffer{};
  const std::string row(buffer.data(),
                        write_row(buffer.data(), record, TickClock(0.001), {.axes = axes}));
  EXPECT_EQ(row.substr(row.size() - 29), ",90.0000000000,-2.5000000000\n");
  EXPECT_EQ(std::count(row.begin(), row.end(), ','), 15);
}

TEST(TraceRow, WritesNoNegativeZero) {
  const TickRecord record{.motion = {.s_mm = 0.0, .v_mm_s = -1e-9, .a_mm_s2 = -0.0},
                          .position_mm = {-1e-11, -0.0, -0.6e-10}};
  EXPECT_EQ(row_of(record, 0.001),
            "0.000000,0,0.0000000000,0.000000,0.000000,0.000000,"
            "0.0000000000,0.0000000000,-0.0000000001,0.0000000000,0.0000000000,0.0000000000,,0."
            "0000000000\n");
}

TEST(TraceRow, HasTheParameterOfACurveAndTheChordError) {
  const TickRecord record{.detail = {.curve_parameter = 0.346605, .chord_error_mm = 5e-4}};
  EXPECT_TRUE(row_of(record, 0.001).ends_with(",0.3466050000,0.0005000000\n"));
}

TEST(TraceRow, FitsEvenWhereEveryNumberIsTheLargest) {
  constexpr double kLargest = -std::numeric_limits<double>::max();
  const TickRecord record{.tick = std::numeric_limits<std::int64_t>::max() / 1000,
                          .line = std::numeric_limits<std::uint32_t>::max(),
                          .motion = {kLargest, kLargest, kLargest, kLargest},
                          .position_mm = {kLargest, kLargest, kLargest},
                          .actual_mm = {kLargest, kLargest, kLargest}};
  EXPECT_LT(row_of(record, 0.001).size(), kMaxRowBytes);
}

TEST(TickClock, IsExactHoweverManyTicks) {
  EXPECT_EQ(time_of(0, 0.001), "0.000000");
  EXPECT_EQ(time_of(1, 0.001), "0.001000");
  EXPECT_EQ(time_of(86'400'001, 0.001), "86400.001000");
  EXPECT_EQ(time_of(9'007'199'254'740'993, 0.001), "9007199254740.993000");
}

TEST(TickClock, TakesAsManyDecimalsAsThePeriodNeeds) {
  EXPECT_EQ(time_of(3, 0.000125), "0.000375");
  EXPECT_EQ(time_of(3, 0.0000625), "0.0001875");
  EXPECT_EQ(time_of(7, 0.00001), "0.000070");
}

TEST(TickClock, RoundsWhereThePeriodIsNoDecimalFraction) {
  EXPECT_EQ(time_of(1, 1.0 / 3000.0), "0.000333333333");
  EXPECT_EQ(time_of(3000, 1.0 / 3000.0), "1.000000000000");
}

}  // namespace
}  // namespace kerf::program
