#include <memory>

#include <gtest/gtest.h>

#include "diagnostics/errors/pages.hpp"
#include "tests/parser/program.hpp"
#include "tests/parser/table_top.hpp"

namespace kerf::parser {
namespace {

constexpr std::uint16_t kFirstMachinePage = 1000;  // tests/kernel has their triggers

std::vector<const diagnostics::ErrorPage*> pages_of_the_text() {
  std::vector<const diagnostics::ErrorPage*> pages;
  for (const diagnostics::ErrorPage* page : errors::catalogue()) {
    if (page->number < kFirstMachinePage) {
      pages.push_back(page);
    }
  }
  return pages;
}

std::string page_name_of(const testing::TestParamInfo<const diagnostics::ErrorPage*>& info) {
  return identifier(*info.param);
}

TEST(ErrorPages, AreFoundByTheirNumbers) {
  for (const diagnostics::ErrorPage* page : errors::catalogue()) {
    EXPECT_EQ(errors::find_page(page->number), page);
  }
  EXPECT_EQ(errors::find_page(0), nullptr);
  EXPECT_EQ(errors::find_page(9999), nullptr);
}

class ErrorPageTrigger : public testing::TestWithParam<const diagnostics::ErrorPage*> {};

TEST_P(ErrorPageTrigger, GivesThisVeryPageFirst) {
  const diagnostics::ErrorPage& page = *GetParam();
  MachineData machine = default_program_data();
  machine.extra_axes = &page == &errors::kAuxiliaryAxisHere ? letters('A') : 0;
  const auto linked = [](std::string_view name) {
    const SubprogramText refused{.file = "linked.ngc", .text = {}, .refused = "it is a link"};
    return name == "linked" ? std::optional(refused) : std::nullopt;
  };
  const Program program = read_program(
      errors::trigger_of(page), {.dialect = page.dialect.empty() ? Dialect::rs274 : Dialect::fanuc,
                                 .answers = {.assumed = std::make_shared<const TableTop>()},
                                 .machine = machine,
                                 .subprograms = linked});
  ASSERT_FALSE(program.diagnostics.empty()) << page.title;
  // What says that there is more can only come last.
  const bool of_many = &page == &errors::kTooManyErrors || &page == &errors::kTooManyWarnings;
  const diagnostics::Diagnostic& found = of_many && program.diagnostics.size() > 100
                                             ? program.diagnostics[100]
                                             : program.diagnostics.front();
  EXPECT_EQ(identifier(*found.page), identifier(page)) << to_string(found, "trigger");
  EXPECT_TRUE(program.at_end);
}

INSTANTIATE_TEST_SUITE_P(All, ErrorPageTrigger, testing::ValuesIn(pages_of_the_text()),
                         page_name_of);

}  // namespace
}  // namespace kerf::parser
