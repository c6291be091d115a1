#include "bench/real_programs.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "bench/program_text.hpp"

namespace kerf::bench {

namespace {

std::filesystem::path programs_folder() {
  const char* const given = std::getenv("KERF_PROGRAMS_DIR");
  return given != nullptr
             ? std::filesystem::path(given)
             : std::filesystem::path(KERF_SOURCE_DIR).parent_path() / "shared/reference/programs";
}

}  // namespace

std::vector<RealProgram> programs_by_others() {
  std::istringstream lines(source_file("tests/programs.tsv"));
  std::vector<RealProgram> programs;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream columns(line);
    std::string name;
    std::string dialect;
    std::string verdict;
    columns >> name >> dialect >> verdict;
    std::ifstream file(programs_folder() / name, std::ios::binary);
    if (verdict == "runs" && file) {
      MachineSettings settings = default_machine();
      settings.dialect = dialect == "fanuc" ? Dialect::fanuc : Dialect::rs274;
      programs.push_back(
          {.name = name,
           .text = {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()},
           .settings = settings});
    }
  }
  return programs;
}

}  // namespace kerf::bench
