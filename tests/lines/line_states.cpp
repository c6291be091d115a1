// What `explain` says at every line of a program, and what a start shows at every one that is a
// multiple of STEP, without a process for each: line_states PROGRAM MACHINE.toml rs274|fanuc STEP
//
// One JSON object a line: {"line", "runs" (how often), "is_asked" (a start), "start", "refused",
// "explain"}; no start and no explain where the line never runs. Precondition: `kerf check` takes
// the program.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kernel/pipeline_observer.hpp"
#include "programs/kerf/cli/machine_choice.hpp"
#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/io/subprogram_folder.hpp"
#include "programs/kerf/report/block_json.hpp"
#include "programs/kerf/run/block_watch.hpp"
#include "programs/kerf/run/plan_only.hpp"
#include "programs/kerf/run/start_search.hpp"

namespace kerf::program {
namespace {

using Json = nlohmann::ordered_json;

// The watch of each line, which `explain` has one of. When its motion begins is not asked.
class WatchOfEachLine final : public BlockWatch {
 public:
  explicit WatchOfEachLine(std::uint32_t lines) : BlockWatch({}), runs_(lines) {
    for (std::uint32_t line = 1; line <= lines; ++line) {
      watches_.push_back(std::make_unique<BlockWatch>(Settings{.line = line}));
    }
  }
  [[nodiscard]] const BlockWatch& of(std::uint32_t line) const { return *watches_[line - 1]; }
  [[nodiscard]] std::uint64_t runs(std::uint32_t line) const { return runs_[line - 1]; }

  void about_to_run(const parser::UpcomingBlock& block) override {
    if (block.source.file == 0 && block.source.line <= watches_.size()) {
      watches_[block.source.line - 1]->about_to_run(block);
      ++runs_[block.source.line - 1];
    }
  }

 private:
  std::vector<std::unique_ptr<BlockWatch>> watches_;
  std::vector<std::uint64_t> runs_;
};

std::uint32_t count_lines(ProgramFile& file) {
  std::uint32_t lines = 1;
  for (auto piece = file.read(); piece && !piece->empty(); piece = file.read()) {
    lines += static_cast<std::uint32_t>(std::ranges::count(*piece, '\n'));
  }
  file.rewind();
  return lines;
}

int write_states(ProgramFile& file, const MachineSettings& settings, const KernelOptions& options,
                 std::uint32_t step) {
  const std::uint32_t lines = count_lines(file);
  WatchOfEachLine watches(lines);
  Progress progress;
  const auto planned = plan_only(
      file, {.settings = settings, .options = options, .max_time_s = 1e9}, progress, watches);
  if (!planned || !planned->errors.empty() || planned->fault) {
    std::cerr << "it cannot be planned\n";
    return EXIT_FAILURE;
  }
  const parser::Letters extra = settings.program.extra_axes;
  for (std::uint32_t line = 1; line <= lines; ++line) {
    Json json{{"line", line}, {"runs", watches.runs(line)}};
    if (const auto& block = watches.of(line).block()) {
      json["explain"] = block_json({.line = line, .block = *block}, extra);
    }
    if (json["is_asked"] = line % step == 0; line % step == 0) {
      file.rewind();
      if (const auto found = find_start(file, {.settings = settings, .options = options},
                                        {.line = line, .round = 1})) {
        json["start"] = start_json(found->start, extra);
        json["refused"] = found->refused;
      }
    }
    std::cout << json << '\n';
  }
  return EXIT_SUCCESS;
}

int run(const std::vector<std::string>& words) {
  const std::string& program = words.at(0);
  const auto dialect = words.at(2) == "fanuc" ? parser::Dialect::fanuc : parser::Dialect::rs274;
  MachineOrder order;
  order.file = words.at(1);
  std::vector<std::string> named;
  const auto machine = choose_machine(order, named);
  auto file = ProgramFile::open(program);
  if (!machine || !file) {
    std::cerr << "the program or the machine file cannot be read\n";
    return EXIT_FAILURE;
  }
  KernelOptions options{.asks_machine = true, .one_thread = true, .dialect = dialect};
  options.subprograms = subprograms_beside(program, dialect);
  return write_states(*file, machine->settings, options,
                      static_cast<std::uint32_t>(std::stoul(words.at(3))));
}

}  // namespace
}  // namespace kerf::program

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "line_states PROGRAM MACHINE.toml rs274|fanuc STEP\n";
    return EXIT_FAILURE;
  }
  return kerf::program::run({argv + 1, argv + argc});
}
