// Walks golden/ and bad/: each NAME.ngc has a NAME.expect with what must come out, line by line.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

std::vector<std::filesystem::path> programs_in(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  const std::filesystem::path root = std::filesystem::path(KERF_SOURCE_DIR) / "tests/parser";
  for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
    if (entry.path().extension() == ".ngc") {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string expectation_for(std::filesystem::path program) {
  return read_file(program.replace_extension(".expect"));
}

std::string messages_of(const Program& program) {
  std::string text;
  for (const diagnostics::Diagnostic& diagnostic : program.diagnostics) {
    text += message_line(diagnostic, "").substr(1) + '\n';
  }
  return text;
}

class ProgramFile : public testing::TestWithParam<std::filesystem::path> {};
using GoodProgram = ProgramFile;
using BadProgram = ProgramFile;

std::string golden_name_of(const testing::TestParamInfo<std::filesystem::path>& info) {
  return info.param.stem().string();
}

TEST_P(GoodProgram, BecomesTheMovesWrittenBesideIt) {
  const Program program = read_program(read_file(GetParam()));
  std::string text = messages_of(program);
  for (const Move& move : program.moves) {
    text += text_of(move) + '\n';
  }
  EXPECT_EQ(text, expectation_for(GetParam()));
  EXPECT_TRUE(program.at_end);
}

TEST_P(BadProgram, GetsTheMessagesWrittenBesideIt) {
  const Program program = read_program(read_file(GetParam()));
  EXPECT_EQ(messages_of(program), expectation_for(GetParam()));
  EXPECT_TRUE(program.at_end);
}

INSTANTIATE_TEST_SUITE_P(Golden, GoodProgram, testing::ValuesIn(programs_in("golden")),
                         golden_name_of);
INSTANTIATE_TEST_SUITE_P(Bad, BadProgram, testing::ValuesIn(programs_in("bad")), golden_name_of);

TEST(ProgramFolders, HoldPrograms) {
  EXPECT_GT(programs_in("bad").size(), 150U);
  EXPECT_GT(programs_in("golden").size(), 5U);
}

}  // namespace
}  // namespace kerf::parser
