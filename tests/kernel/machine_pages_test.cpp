// The triggers of the pages about the machine, and that no other page hides among them.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/errors/pages.hpp"

namespace kerf::test {
namespace {

constexpr std::array kOfTheCheck{&errors::kOutsideTravel,    &errors::kCurveRefused,
                                 &errors::kTooLong,          &errors::kNobodyAnswers,
                                 &errors::kTooManyMoves,     &errors::kFeedBeyondReach,
                                 &errors::kToleranceSwallows};

std::vector<diagnostics::Diagnostic> found_in(const diagnostics::ErrorPage& page) {
  MachineSettings settings;
  settings.limits.path.velocity_mm_s = 100.0;
  for (auto& axis : settings.table.axes) {
    axis.travel = {.min_mm = -300.0, .max_mm = 300.0};
  }
  std::string text = errors::trigger_of(page);
  const CheckReport report = check_program(
      [&text, read = false]() mutable {
        const std::string_view piece = read ? std::string_view{} : std::string_view(text);
        read = true;
        return piece;
      },
      settings, {.refuses_waits = true}, {.max_time_s = 1000.0, .max_moves = 200'000});
  std::vector<diagnostics::Diagnostic> all = report.diagnostics;
  all.insert(all.end(), report.limit_faults.begin(), report.limit_faults.end());
  return all;
}

TEST(MachinePages, OfTheCheckHaveTheirTriggers) {
  for (const diagnostics::ErrorPage* page : kOfTheCheck) {
    const auto found = found_in(*page);
    ASSERT_FALSE(found.empty()) << page->title;
    EXPECT_EQ(found.front().page, page) << found.front().message;
  }
}

TEST(MachinePages, OfAMachineWithoutALimitHasItsTrigger) {
  MachineSettings settings;
  settings.limits = {};
  Kernel kernel(settings, {});
  kernel.feed(errors::trigger_of(errors::kMachineWithoutLimit));
  kernel.finish();
  kernel.plan();
  ASSERT_FALSE(kernel.diagnostics().empty());
  EXPECT_EQ(kernel.diagnostics().front().page, &errors::kMachineWithoutLimit);
}

TEST(MachinePages, OfAnImpossibleSettingHasItsTrigger) {
  Kernel kernel(default_machine(), {.horizon_s = -1.0});
  kernel.feed(errors::trigger_of(errors::kImpossibleSetting));
  kernel.finish();
  kernel.plan();
  ASSERT_FALSE(kernel.diagnostics().empty());
  EXPECT_EQ(kernel.diagnostics().front().page, &errors::kImpossibleSetting);
}

TEST(MachinePages, AreAllTriedHere) {
  for (const diagnostics::ErrorPage* page : errors::catalogue()) {
    const bool tried = page == &errors::kMachineWithoutLimit ||
                       page == &errors::kImpossibleSetting ||
                       std::find(kOfTheCheck.begin(), kOfTheCheck.end(), page) != kOfTheCheck.end();
    EXPECT_TRUE(page->number < 1000 || tried) << page->title;
  }
}

}  // namespace
}  // namespace kerf::test
