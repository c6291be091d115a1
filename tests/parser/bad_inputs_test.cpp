// Walks bad_inputs/: what index.tsv wants of each file (an error, a warning or no message at all,
// and on which line) is what the reader says. The wording is the business of bad/.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

struct BadInput {
  std::string file;
  Dialect dialect = Dialect::rs274;
  std::string verdict;     // error, warning or accept
  std::uint32_t line = 0;  // of the first message of that kind; 0: none
};

std::filesystem::path folder() {
  return std::filesystem::path(KERF_SOURCE_DIR) / "tests/parser/bad_inputs";
}

std::vector<BadInput> index() {
  std::istringstream lines(read_file(folder() / "index.tsv"));
  std::vector<BadInput> inputs;
  std::string line;
  std::getline(lines, line);  // the names of the columns
  while (std::getline(lines, line)) {
    std::istringstream columns(line);
    BadInput input;
    std::string dialect;
    columns >> input.file >> dialect >> input.verdict >> input.line;
    if (dialect == "machine") {
      continue;  // only a machine's limits tell: tests/kernel/check_test.cpp
    }
    input.dialect = dialect == "fanuc" ? Dialect::fanuc : Dialect::rs274;
    inputs.push_back(input);
  }
  return inputs;
}

std::string name_of(const testing::TestParamInfo<BadInput>& info) {
  return std::filesystem::path(info.param.file).stem().string() +
         (info.param.dialect == Dialect::fanuc ? "_fanuc" : "");
}

const diagnostics::Diagnostic* first_of(const Program& program, diagnostics::Severity severity) {
  const auto found =
      std::find_if(program.diagnostics.begin(), program.diagnostics.end(),
                   [&](const diagnostics::Diagnostic& one) { return one.severity == severity; });
  return found == program.diagnostics.end() ? nullptr : &*found;
}

class BadInputFile : public testing::TestWithParam<BadInput> {};

TEST_P(BadInputFile, GetsTheVerdictOnTheRightLine) {
  const BadInput& wanted = GetParam();
  ReaderOptions options;
  options.dialect = wanted.dialect;
  options.machine = default_program_data();
  const Program program = read_program(read_file(folder() / wanted.file), options);
  EXPECT_TRUE(program.at_end);
  const diagnostics::Diagnostic* const error = first_of(program, diagnostics::Severity::error);
  const diagnostics::Diagnostic* const warning = first_of(program, diagnostics::Severity::warning);
  const diagnostics::Diagnostic* const first = error != nullptr ? error : warning;
  const std::string said = first == nullptr ? "nothing" : to_string(*first, wanted.file);
  if (wanted.verdict == "accept") {
    EXPECT_EQ(first, nullptr) << said;
    return;
  }
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->severity, wanted.verdict == "error" ? diagnostics::Severity::error
                                                       : diagnostics::Severity::warning)
      << said;
  EXPECT_EQ(first->source.line, wanted.line) << said;
  EXPECT_EQ(first->message.find("not supported yet"), std::string::npos) << said;
}

INSTANTIATE_TEST_SUITE_P(BadInputs, BadInputFile, testing::ValuesIn(index()), name_of);

TEST(BadInputs, AreAllInTheIndex) {
  std::set<std::string> listed;
  for (const BadInput& input : index()) {
    listed.insert(input.file);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name == "index.tsv" || name == "142_axis_soft_limit.ngc" || listed.count(name) == 1)
        << name;
  }
  EXPECT_GE(listed.size(), 300U);
}

}  // namespace
}  // namespace kerf::parser
