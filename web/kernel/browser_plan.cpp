// A program planned in the browser: the same report as `kerf report` makes, called from a worker.
#include <cstddef>
#include <cstdint>
#include <emscripten.h>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <kerf/machine.hpp>
#include <nlohmann/json.hpp>

#include "programs/kerf/cli/machine_choice.hpp"
#include "programs/kerf/page/plan_document.hpp"
#include "programs/kerf/run/machine_run.hpp"
#include "programs/kerf/run/session.hpp"

// There is no machine behind a page.
std::string kerf::program::run_machine(MotionStage& stage, Driver& /*driver*/) {
  stage.report().fail(ExitStatus::settings_error, "nothing runs in a browser");
  return {};
}

// To the worker: of each run of a line that has ended since the last call the line and its ticks;
// the line that is run now, all ticks and the length of the path so far, and how long the rest will
// take, or less than 0.
EM_JS(void, tell_progress,
      (const std::uint32_t* runs, std::size_t count, std::uint32_t line, double ticks,
       double path_mm, double left_s),
      {
        Module["told"](
            {lines : HEAPU32.slice(runs >> 2, (runs >> 2) + count), line, ticks, path_mm, left_s});
      });

// What there is of the plan before its times: a plan document.
EM_JS(void, tell_path, (const char* document, std::size_t bytes),
      { Module["toldPath"](HEAPU8.slice(document, document + bytes)); });

namespace {

using kerf::MachineSettings;
using Json = nlohmann::json;

// Bounds of what a page waits for; the first is of machine time.
constexpr double kMaxTime_s = 86'400.0;
constexpr std::uint64_t kMaxMoves = 10'000'000;
constexpr std::size_t kMaxColumns = 1'000'000;  // some 400 MB while they are gathered

std::string answer;  // to the last order: valid until the next

// In place of a plan: {"refused": ["table.toml:3:1: error: ..."]}
std::string refusal(const std::vector<std::string>& messages) {
  return Json{{"refused", messages}}.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::filesystem::path name_of(const Json& file) {
  // The name alone: a browser tells no folder.
  return std::filesystem::path(file.at("name").get<std::string>()).filename();
}

// Subprograms are looked for beside the program, and beside the machine file what that names, so
// all files go into one folder, which is the present one from then on: reports name the file alone.
void write_files(const char* folder_name, const Json& files) {
  const auto folder = std::filesystem::temp_directory_path() / folder_name;
  std::filesystem::current_path(folder.parent_path());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
  for (const Json& file : files) {
    std::ofstream(name_of(file), std::ios::binary) << file.at("text").get_ref<const std::string&>();
  }
}

// Tells how far the plan is, some times a second.
class ProgressTeller {
 public:
  void operator()(const kerf::program::PlanGatherer& gathered, const kerf::Kernel& kernel) {
    const double now_ms = emscripten_get_now();
    if (now_ms < told_ms_ + kPause_ms) {
      return;
    }
    told_ms_ = now_ms;
    const auto& runs = gathered.runs().runs();
    std::vector<std::uint32_t> lines;
    // Of very many runs some become one, and there is more to do than to tell of them.
    for (; gathered.runs().shortest_ticks() == 1 && told_runs_ + 1 < runs.size(); ++told_runs_) {
      const kerf::program::LineRun& run = runs[told_runs_];
      lines.push_back(run.line);
      lines.push_back(static_cast<std::uint32_t>(runs[told_runs_ + 1].tick - run.tick));
    }
    tell_progress(lines.data(), lines.size(), runs.empty() ? 0 : runs.back().line,
                  static_cast<double>(gathered.last_tick()), gathered.path_mm(),
                  kernel.left_s().value_or(-1.0));
  }

 private:
  static constexpr double kPause_ms = 200.0;
  double told_ms_ = emscripten_get_now();
  std::size_t told_runs_ = 0;
};

kerf::program::Options options_of(const Json& order) {
  kerf::program::Options options;
  options.command = kerf::program::Subcommand::report;
  options.profile = kerf::profile_kind(order.at("profile").get<std::string>()).value();
  options.feed_override = order.at("feed_override").get<double>();
  options.explained_speed.emplace();
  options.max_time_s = kMaxTime_s;
  options.max_moves = kMaxMoves;
  options.quiet = true;
  return options;
}

// Where the machine file looks for it, which may be in another folder: a browser tells none.
void put_where_it_is_named(const std::filesystem::path& named) {
  const std::filesystem::path here = named.filename();
  if (named != here && std::filesystem::exists(here)) {
    std::filesystem::create_directories(named.parent_path());
    std::filesystem::copy_file(here, named, std::filesystem::copy_options::overwrite_existing);
  }
}

// The machine file, and after it the files that it names; an empty text is the default machine.
tl::expected<MachineSettings, kerf::program::MachineRefusal> machine_of(const Json& files) {
  kerf::program::MachineOrder order;
  if (const auto& text = files.at(0).at("text").get_ref<const std::string&>(); !text.empty()) {
    write_files("machine", files);
    order.file = name_of(files.at(0)).string();
    if (const auto read = kerf::parse_machine_file(text)) {
      put_where_it_is_named(read->tool_file);
      put_where_it_is_named(read->height_map_file);
    }
  }
  std::vector<std::string> named;
  auto chosen = kerf::program::choose_machine(order, named);
  if (chosen) {
    return std::move(chosen->settings);
  }
  if (chosen.error().status == kerf::program::ExitStatus::io_error) {
    for (std::string& message : chosen.error().messages) {
      message += ": open it here, too, for the machine file names it";
    }
  }
  return tl::unexpected(std::move(chosen.error()));
}

// {"files": [{"name", "text"}, ...], "machine": [{"name", "text"}, ...], "profile": "s-curve",
// "feed_override": 1.0}. The first file is the program, the others its subprograms; machine: as of
// machine_of(). The path is told before its times are planned.
// With "part": {"first": 1000, "last": 1999} the plan has columns of these ticks alone, ends after
// them, and nothing is told before it.
std::string plan(const Json& order) {
  const Json& machine = order.at("machine");
  const auto read = machine_of(machine);
  if (!read) {
    return refusal(read.error().messages);
  }
  const MachineSettings& settings = *read;
  kerf::program::Options options = options_of(order);
  if (!machine.at(0).at("text").get_ref<const std::string&>().empty()) {
    options.machine_file = machine.at(0).at("name").get<std::string>();
  }
  write_files("programs", order.at("files"));
  // The page has the text.
  kerf::program::PageRecord record{.wants_source = false, .max_columns = kMaxColumns};
  if (const auto part = order.find("part"); part != order.end()) {
    record.window = {.first = part->at("first").get<std::int64_t>(),
                     .last = part->at("last").get<std::int64_t>()};
  } else {
    record.watch = ProgressTeller{};
    record.show_path = [&](const kerf::program::FileReport& report) {
      const std::string document = plan_document(report, settings, record);
      tell_path(document.data(), document.size());
    };
  }
  const auto report =
      kerf::program::process_file(name_of(order.at("files").at(0)), options, settings, &record);
  return plan_document(report, settings, record);
}

}  // namespace

extern "C" {

// order: JSON as of plan(), of that many bytes, UTF-8. Returns where the answer begins: a plan
// document (docs/page-data.md), or a refusal.
EMSCRIPTEN_KEEPALIVE const char* kerf_plan(const char* order, std::size_t bytes) {
  try {
    answer = plan(Json::parse(std::string_view(order, bytes)));
  } catch (const std::exception& exception) {
    answer = refusal({std::string("internal error: ") + exception.what()});
  }
  return answer.data();
}

EMSCRIPTEN_KEEPALIVE std::size_t kerf_plan_bytes() {
  return answer.size();
}

}  // extern "C"
