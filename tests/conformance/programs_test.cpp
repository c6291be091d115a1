// Real programs by others: each runs, or is refused on the line and for the reason that
// tests/programs.tsv gives. The programs are not ours to ship; they are looked for in the folder
// that KERF_PROGRAMS_DIR names, else in ../shared/reference/programs beside the checkout.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "parser/program_reader.hpp"
#include "tests/conformance/programs_folder.hpp"

namespace kerf::conformance {
namespace {

using diagnostics::Diagnostic;
using parser::ProgramReader;

struct RealProgram {
  std::string file;
  std::string dialect;  // rs274 or fanuc
  std::string verdict;  // runs or refused
  std::string line;     // of the first error; - where it runs
  std::string error;    // its identifier
  std::string reason;
};

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<RealProgram> table() {
  std::istringstream lines(
      read_file(std::filesystem::path(KERF_SOURCE_DIR) / "tests/programs.tsv"));
  std::vector<RealProgram> programs;
  std::string line;
  std::getline(lines, line);  // the names of the columns
  while (std::getline(lines, line)) {
    std::istringstream columns(line);
    RealProgram program;
    for (std::string* column : {&program.file, &program.dialect, &program.verdict, &program.line,
                                &program.error, &program.reason}) {
      std::getline(columns, *column, '\t');
    }
    programs.push_back(program);
  }
  return programs;
}

std::string program_name_of(const testing::TestParamInfo<RealProgram>& info) {
  std::string name = info.param.file;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

// Reads to the end, or to more moves than any of these programs has.
const Diagnostic* first_error(ProgramReader& reader, const std::string& text) {
  constexpr int kMoves = 1'000'000;
  parser::Move move;
  int moves = 0;
  reader.feed(text);
  reader.finish();
  while (reader.next(move)) {
    if (++moves > kMoves) {
      ADD_FAILURE() << "it has no end";
      break;
    }
  }
  const auto& all = reader.diagnostics();
  const auto found = std::find_if(all.begin(), all.end(), [](const Diagnostic& one) {
    return one.severity == diagnostics::Severity::error;
  });
  return found == all.end() ? nullptr : &*found;
}

std::string identifier_of(const Diagnostic& error) {
  const std::string number = std::to_string(error.page == nullptr ? 0 : error.page->number);
  return "E" + std::string(4 - std::min<std::size_t>(4, number.size()), '0') + number;
}

class RealProgramFile : public testing::TestWithParam<RealProgram> {};

TEST_P(RealProgramFile, RunsOrIsRefusedForTheReasonGiven) {
  const RealProgram& wanted = GetParam();
  const std::filesystem::path path = programs_folder() / wanted.file;
  if (!std::filesystem::exists(path)) {
    GTEST_SKIP() << path << " is not here; KERF_PROGRAMS_DIR names the folder";
  }
  parser::ReaderOptions options;
  options.dialect = wanted.dialect == "fanuc" ? parser::Dialect::fanuc : parser::Dialect::rs274;
  options.machine = parser::default_program_data();
  ProgramReader reader(options);
  const Diagnostic* const error = first_error(reader, read_file(path));
  const std::string said = error == nullptr ? "nothing" : to_string(*error, wanted.file);
  EXPECT_EQ(error == nullptr ? "runs" : "refused", wanted.verdict) << said;
  if (error != nullptr) {
    EXPECT_EQ(std::to_string(error->source.line), wanted.line) << said;
    EXPECT_EQ(identifier_of(*error), wanted.error) << said;
  }
}

TEST(RealPrograms, AreAllInTheTable) {
  if (!std::filesystem::is_directory(programs_folder())) {
    GTEST_SKIP() << programs_folder() << " is not here; KERF_PROGRAMS_DIR names the folder";
  }
  const std::vector<RealProgram> programs = table();
  for (const auto& entry : std::filesystem::directory_iterator(programs_folder())) {
    const std::string name = entry.path().filename().string();
    const bool listed = std::any_of(programs.begin(), programs.end(),
                                    [&](const RealProgram& one) { return one.file == name; });
    EXPECT_TRUE(listed || name == "index.tsv") << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, RealProgramFile, testing::ValuesIn(table()), program_name_of);

}  // namespace
}  // namespace kerf::conformance
