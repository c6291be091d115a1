#include <cstddef>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

extern "C" {
const char* kerf_plan(const char* order, std::size_t bytes);
std::size_t kerf_plan_bytes();
}

namespace kerf::test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Json answer_to(const std::string& order) {
  const char* answer = kerf_plan(order.data(), order.size());
  return Json::parse(std::string(answer, kerf_plan_bytes()));
}

TEST(BrowserPlan, RefusesAMachineFileWithTheLine) {
  const Json order{
      {"files", {{{"name", "part.ngc"}, {"text", "G1 X1 F100\nM2\n"}}}},
      {"machine", {{"name", "table.toml"}, {"text", "[path]\n\nvelocity = \"fast\"\n"}}},
      {"profile", "time-optimal"},
      {"feed_override", 1.0},
      {"path_first", false}};
  const Json answer = answer_to(order.dump());
  ASSERT_TRUE(answer.contains("refused"));
  EXPECT_THAT(answer["refused"].get<std::vector<std::string>>(),
              testing::Contains(StartsWith("table.toml:3:")));
}

TEST(BrowserPlan, TellsAnOrderThatItCannotRead) {
  const Json answer = answer_to("{");
  EXPECT_THAT(answer["refused"].get<std::vector<std::string>>(),
              ElementsAre(HasSubstr("internal error")));
}

}  // namespace
}  // namespace kerf::test
