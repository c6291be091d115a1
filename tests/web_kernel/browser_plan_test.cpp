#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/temporary_folder.hpp"

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

class BrowserPlan : public testing::Test {
 protected:
  // The planner writes what it is given into the folder of temporary files.
  BrowserPlan() { setenv("TMPDIR", folder_.path().c_str(), 1); }
  ~BrowserPlan() override {
    std::filesystem::current_path(folder_.path().parent_path());
    unsetenv("TMPDIR");
  }

  static Json answer_to(const std::string& order) {
    const char* answer = kerf_plan(order.data(), order.size());
    const std::string text(answer, kerf_plan_bytes());
    return Json::accept(text) ? Json::parse(text) : Json::object();
  }

  static Json answer_with_machine(const Json& files) {
    const Json order{{"files", {file("part.ngc", "G1 X1 F100\nM2\n")}},
                     {"machine", files},
                     {"profile", "time-optimal"},
                     {"feed_override", 1.0}};
    return answer_to(order.dump());
  }

  static Json file(const std::string& name, const std::string& text) {
    return Json{{"name", name}, {"text", text}};
  }

 private:
  program::TemporaryFolder folder_;
};

TEST_F(BrowserPlan, RefusesAMachineFileWithTheLine) {
  const Json answer =
      answer_with_machine(Json::array({file("table.toml", "[path]\n\nvelocity = \"fast\"\n")}));
  ASSERT_TRUE(answer.contains("refused"));
  EXPECT_THAT(answer["refused"].get<std::vector<std::string>>(),
              testing::Contains(StartsWith("table.toml:3:")));
}

TEST_F(BrowserPlan, TakesTheToolTableWhereTheMachineFileLooksForIt) {
  const Json machine = file(
      "shop.toml",
      "[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 20000\n"
      "[tools]\nfile = \"tables/shop.tbl\"\n");
  const Json alone = answer_with_machine(Json::array({machine}));
  ASSERT_TRUE(alone.contains("refused"));
  EXPECT_THAT(alone["refused"].get<std::vector<std::string>>(),
              testing::Contains(HasSubstr("shop.tbl")));

  const Json both = answer_with_machine(Json::array({machine, file("shop.tbl", "T1 P1 Z10\n")}));
  EXPECT_FALSE(both.contains("refused")) << both;
}

TEST_F(BrowserPlan, TellsAnOrderThatItCannotRead) {
  const Json answer = answer_to("{");
  EXPECT_THAT(answer["refused"].get<std::vector<std::string>>(),
              ElementsAre(HasSubstr("internal error")));
}

}  // namespace
}  // namespace kerf::test
