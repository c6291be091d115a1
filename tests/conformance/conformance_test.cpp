// Programs of one thing each, by topic, against LinuxCNC's answers: NAME.golden beside NAME.ngc is
// what rs274 said (make_golden wrote it). Where Kerf is right and LinuxCNC is not, NAME.kerf says
// what is right and differences.md why.
#include <algorithm>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "tests/conformance/answer.hpp"

namespace kerf::conformance {
namespace {

std::filesystem::path root() {
  return std::filesystem::path(KERF_SOURCE_DIR) / "tests/conformance";
}

std::vector<std::filesystem::path> files(const std::string& extension) {
  std::vector<std::filesystem::path> paths;
  for (const auto& topic : std::filesystem::directory_iterator(root())) {
    if (!topic.is_directory()) {
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(topic)) {
      if (entry.path().extension() == extension) {
        paths.push_back(entry.path());
      }
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::filesystem::path beside(std::filesystem::path program, const char* extension) {
  return program.replace_extension(extension);
}

std::string name_of(const testing::TestParamInfo<std::filesystem::path>& info) {
  return info.param.parent_path().filename().string() + "_" + info.param.stem().string();
}

class Conformance : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Conformance, MovesAsLinuxCncDoes) {
  const std::filesystem::path ours = beside(GetParam(), ".kerf");
  const Answer linuxcnc = read_answer(beside(GetParam(), ".golden"));
  const bool differs = std::filesystem::exists(ours);
  const Answer wanted = differs ? read_answer(ours) : linuxcnc;
  EXPECT_EQ(first_difference(wanted, kerf_answer(GetParam())), "");
  EXPECT_TRUE(differs || linuxcnc.refusal.empty()) << linuxcnc.refusal;
  EXPECT_TRUE(!differs || !first_difference(linuxcnc, wanted).empty()) << "no difference any more";
}

INSTANTIATE_TEST_SUITE_P(LinuxCnc, Conformance, testing::ValuesIn(files(".ngc")), name_of);

TEST(Differences, AreAllExplained) {
  std::ifstream file(root() / "differences.md");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  for (const std::filesystem::path& difference : files(".kerf")) {
    const std::string name =
        difference.parent_path().filename().string() + "/" + difference.stem().string();
    EXPECT_NE(text.find("`" + name + "`"), std::string::npos) << name;
  }
}

TEST(ConformancePrograms, HaveAnAnswerEach) {
  const auto programs = files(".ngc");
  EXPECT_EQ(programs.size(), files(".golden").size());
  EXPECT_GE(programs.size(), 200U);
}

}  // namespace
}  // namespace kerf::conformance
