#include "parser/expressions/parameters.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::parser {
namespace {

// A machine whose position is known.
class Machine final : public PredefinedValues {
 public:
  [[nodiscard]] std::optional<double> number(int number) const override {
    return number == 5420 || number == 5041 ? std::optional(x) : std::nullopt;
  }
  [[nodiscard]] std::optional<double> name(std::string_view name) const override {
    return name == "_x" ? std::optional(x) : std::nullopt;
  }
  bool take(int number, double value) override {
    taken = number == 5221 ? value : taken;
    return number == 5221;
  }
  double x = 12.5;
  double taken = 0.0;
};

TEST(Parameters, NumberedOnesAreZeroBeforeTheyAreWritten) {
  Parameters parameters;
  EXPECT_EQ(parameters.get(1), 0.0);
  EXPECT_EQ(parameters.set(31, 2.5), Write::done);
  EXPECT_EQ(parameters.get(31), 2.5);
}

// rs274 2.9: #0 and #5602 "Parameter number out of range".
TEST(Parameters, GoFromOneTo5601) {
  Parameters parameters;
  for (const int number : {0, -1, 5602, 99999, 2147483647}) {
    EXPECT_FALSE(parameters.get(number)) << number;
    EXPECT_EQ(parameters.set(number, 1), Write::no_such_parameter) << number;
  }
  EXPECT_EQ(parameters.set(5601, 1), Write::done);
}

// rs274 2.9 refuses to write exactly these.
TEST(Parameters, ToolAndPositionAreReadOnly) {
  Parameters parameters;
  for (int number = 1; number <= 5601; ++number) {
    const bool read_only = (number >= 5400 && number <= 5413) || (number >= 5420 && number <= 5428);
    EXPECT_EQ(parameters.set(number, 1), read_only ? Write::read_only : Write::done) << number;
  }
}

TEST(Parameters, NamesIgnoreCaseAndBlanks) {
  Parameters parameters;
  EXPECT_FALSE(parameters.get("ab c"));
  EXPECT_EQ(parameters.set("a B\tc", 5), Write::done);
  EXPECT_EQ(parameters.get("ABC"), 5.0);
  EXPECT_EQ(parameters.set("_Shared One", 6), Write::done);
  EXPECT_EQ(parameters.get("_sharedone"), 6.0);
}

// rs274 2.9: o100 call [3] sees #1 = 3 and #5 = 0; after it #5 is the caller's again, #31 is
// shared.
TEST(Parameters, ACallHasItsOwnLocals) {
  Parameters parameters;
  parameters.set(5, 7);
  parameters.set("local", 1);
  parameters.set("_shared", 2);
  parameters.push_frame(std::array{3.0});
  EXPECT_EQ(parameters.get(1), 3.0);
  EXPECT_EQ(parameters.get(5), 0.0);
  EXPECT_FALSE(parameters.get("local"));
  parameters.set(30, 4);
  parameters.set(31, 9);
  parameters.set("local", 10);
  parameters.set("_shared", 11);
  parameters.pop_frame();
  EXPECT_EQ(parameters.get(1), 0.0);
  EXPECT_EQ(parameters.get(5), 7.0);
  EXPECT_EQ(parameters.get(30), 0.0);
  EXPECT_EQ(parameters.get(31), 9.0);
  EXPECT_EQ(parameters.get("local"), 1.0);
  EXPECT_EQ(parameters.get("_shared"), 11.0);
}

TEST(Parameters, CallsNest) {
  Parameters parameters;
  for (int depth = 1; depth <= 32; ++depth) {
    parameters.push_frame(std::array{double(depth), -1.0});
    parameters.set("depth", depth);
  }
  for (int depth = 32; depth >= 1; --depth) {
    EXPECT_EQ(parameters.depth(), static_cast<std::size_t>(depth));
    EXPECT_EQ(parameters.get(1), depth);
    EXPECT_EQ(parameters.get("depth"), depth);
    parameters.pop_frame();
  }
  EXPECT_EQ(parameters.depth(), 0U);
}

TEST(Parameters, MoreArgumentsThanLocalsAreNotUsed) {
  Parameters parameters;
  parameters.set(31, 8);
  parameters.push_frame(std::vector<double>(40, 1.0));
  EXPECT_EQ(parameters.get(30), 1.0);
  EXPECT_EQ(parameters.get(31), 8.0);
}

TEST(Parameters, PredefinedValuesComeFirstAndAreReadOnly) {
  Machine machine;
  Parameters parameters;
  parameters.use(machine);
  EXPECT_EQ(parameters.get(5420), 12.5);
  EXPECT_EQ(parameters.get("_X"), 12.5);
  machine.x = 13;
  EXPECT_EQ(parameters.get(5420), 13.0);
  EXPECT_EQ(parameters.set("_x", 4), Write::read_only);
  EXPECT_EQ(parameters.set(5221, 4), Write::done);
  EXPECT_EQ(machine.taken, 4.0);
  EXPECT_EQ(parameters.get(5221), 0.0);
}

TEST(FanucVariables, AreVacantBeforeTheyAreWritten) {
  Parameters variables(Dialect::fanuc);
  for (const int number : {0, 1, 33, 100, 199, 500, 999}) {
    ASSERT_TRUE(variables.get(number)) << number;
    EXPECT_TRUE(is_vacant(*variables.get(number))) << number;
    EXPECT_EQ(variables.set(number, 2), number == 0 ? Write::read_only : Write::done) << number;
  }
  EXPECT_EQ(variables.get(33), 2.0);
  EXPECT_EQ(variables.set(33, kVacant), Write::done);
  EXPECT_TRUE(is_vacant(*variables.get(33)));
}

TEST(FanucVariables, DoNotExistBetweenTheirRanges) {
  Parameters variables(Dialect::fanuc);
  for (const int number : {-1, 34, 99, 200, 499, 1000, 5041}) {
    EXPECT_FALSE(variables.get(number)) << number;
    EXPECT_EQ(variables.set(number, 2), Write::no_such_parameter) << number;
  }
  Machine machine;
  variables.use(machine);
  EXPECT_EQ(variables.get(5041), 12.5);
  EXPECT_EQ(variables.set(5041, 2), Write::read_only);
}

TEST(FanucVariables, LocalsOfACallThatGetNoArgumentAreVacant) {
  Parameters variables(Dialect::fanuc);
  variables.set(2, 5);
  variables.push_frame(std::array{1.0});
  EXPECT_EQ(variables.get(1), 1.0);
  EXPECT_TRUE(is_vacant(*variables.get(2)));
  variables.pop_frame();
  EXPECT_TRUE(is_vacant(*variables.get(1)));
  EXPECT_EQ(variables.get(2), 5.0);
}

}  // namespace
}  // namespace kerf::parser
