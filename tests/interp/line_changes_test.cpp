// Which line of the program a tick belongs to, where one curve stands for many lines.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/interp/script.hpp"

namespace kerf::interp::test {
namespace {

const Profile kProfile{ProfileKind::s_curve};

std::uint32_t line_at(const std::vector<LineChange>& changes, double s_mm) {
  std::uint32_t line = 0;
  for (const LineChange& change : changes) {
    line = change.s_mm <= s_mm ? change.line : line;
  }
  return line;
}

// Lines far apart, within a tick of each other, and at the curve's very end.
std::vector<LineChange> changes() {
  return {{.s_mm = 0.0, .line = 10},     {.s_mm = 10.0, .line = 11},
          {.s_mm = 10.0001, .line = 13}, {.s_mm = 37.25, .line = 12},
          {.s_mm = 40.0, .line = 7},     {.s_mm = 49.9999999, .line = 20}};
}

TEST(LineChanges, ATickIsOfTheLineThatItsPlaceBelongsTo) {
  Script script;
  script.curve(line({0, 0, 0}, {30, 40, 0}), changes());
  script.hill(50.0, kProfile);
  script.rest(0.0, true);
  std::vector<std::uint32_t> met;
  Setpoint setpoint;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
    ASSERT_EQ(setpoint.line, line_at(changes(), setpoint.s_mm)) << "tick " << setpoint.tick;
    if (met.empty() || met.back() != setpoint.line) {
      met.push_back(setpoint.line);
    }
  }
  EXPECT_GE(met.size(), 4U);
}

TEST(LineChanges, AChangeHoldsFromItsPlaceOn) {
  Script script;
  script.curve(line({0, 0, 0}, {4, 0, 0}), {{.s_mm = 0.0, .line = 5}, {.s_mm = 2.0, .line = 6}});
  script.law(Transition::cruise(1000.0, 4.0));  // a millimetre a tick
  for (const std::uint32_t expected : {5U, 5U, 6U, 6U}) {
    Setpoint setpoint;
    script.interpolator().next(setpoint);
    EXPECT_EQ(setpoint.line, expected) << setpoint.s_mm;
  }
}

TEST(LineChanges, ARestIsOfItsOwnLine) {
  Script script;
  script.curve(line({0, 0, 0}, {30, 40, 0}), changes());
  script.hill(50.0, kProfile);
  script.rest(0.5, true);
  Setpoint setpoint;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
  }
  EXPECT_EQ(setpoint.line, 3U);
}

TEST(LineChanges, EndWithTheirCurve) {
  Script script;
  script.curve(line({0, 0, 0}, {30, 40, 0}), changes());
  script.law(Transition::cruise(40.0, 50.0));
  script.curve(line({30, 40, 0}, {60, 80, 0}));
  script.law(Transition::cruise(40.0, 50.0));
  script.curve(line({60, 80, 0}, {90, 120, 0}), changes());
  script.law(Transition::cruise(40.0, 50.0));
  Setpoint setpoint;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
    const double on_curve = std::fmod(setpoint.s_mm, 50.0);
    const bool plain = setpoint.s_mm >= 50.0 && setpoint.s_mm < 100.0;
    ASSERT_EQ(setpoint.line, plain ? 3U : line_at(changes(), on_curve)) << setpoint.s_mm;
  }
}

}  // namespace
}  // namespace kerf::interp::test
