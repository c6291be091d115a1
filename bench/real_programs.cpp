#include "bench/real_programs.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include "bench/program_text.hpp"
#include "tests/conformance/programs_folder.hpp"

namespace kerf::bench {

std::vector<RealProgram> programs_by_others() {
  std::istringstream lines(source_file("tests/programs.tsv"));
  std::vector<RealProgram> programs;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream columns(line);
    std::string name;
    std::string dialect;
    std::string verdict;
    columns >> name >> dialect >> verdict;
    std::ifstream file(conformance::programs_folder() / name, std::ios::binary);
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
