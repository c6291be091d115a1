#include "programs/kerf/cli/option_parser.hpp"

#include <map>
#include <optional>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>

#include "programs/kerf/cli/error_page_text.hpp"
#include "programs/kerf/cli/option_list.hpp"
#include "programs/kerf/cli/option_rules.hpp"
#include "programs/kerf/io/visible_text.hpp"

namespace kerf::program {

namespace {

// `kerf errors`: the list of all pages, one of them, or docs/errors.md.
class ErrorPageCommand {
 public:
  explicit ErrorPageCommand(CLI::App& app)
      : command_(app.add_subcommand("errors", "what the errors and warnings mean")) {
    command_->add_option("ID", identifier_, "show this page (E0123)")->type_name("");
    command_->add_flag("--markdown", markdown_, "all pages, as docs/errors.md has them");
  }
  ErrorPageCommand(const ErrorPageCommand&) = delete;
  ErrorPageCommand& operator=(const ErrorPageCommand&) = delete;

  [[nodiscard]] bool chosen() const { return command_->parsed(); }
  [[nodiscard]] tl::expected<std::string, std::string> text() const {
    if (markdown_) {
      return error_pages_markdown();
    }
    return identifier_.empty() ? error_page_list() : error_page_text(identifier_);
  }

 private:
  CLI::App* command_;
  std::string identifier_;
  bool markdown_ = false;
};

Leave wrong_use(const std::string& message) {
  return {.status = ExitStatus::wrong_use,
          .text = "kerf: " + visible(message) + "\nTry: kerf --help\n"};
}

struct TimeWord {
  std::string_view name;
  const std::string& word;  // empty: not given
  double& value_s;
  bool may_be_0 = false;
};

std::optional<std::string> read_time(const TimeWord& time) {
  if (time.word.empty()) {
    return std::nullopt;
  }
  const auto value_s = duration_s_of(time.word);
  if (!value_s || (*value_s == 0.0 && !time.may_be_0)) {
    return std::string(time.name) + " takes seconds, or a number with s, min, h or d; found " +
           time.word;
  }
  time.value_s = *value_s;
  return std::nullopt;
}

std::optional<std::string> read_times(const OptionWords& words, Options& options) {
  for (const TimeWord& time :
       {TimeWord{"--max-time", words.max_time, options.max_time_s},
        TimeWord{"--trace-from", words.trace_from, options.trace_from_s, true},
        TimeWord{"--trace-to", words.trace_to, options.trace_to_s},
        TimeWord{"--time", words.measured, options.measured_s}}) {
    if (auto message = read_time(time)) {
      return message;
    }
  }
  return std::nullopt;
}

// Where the tool and the work are.
std::optional<std::string> read_places(const OptionWords& words, Options& options) {
  if (!words.start.empty()) {
    const auto start = start_place_of(words.start);
    if (!start) {
      return "--start takes X,Y,Z in mm, as in --start 10,0,-5.5, or first-move; found " +
             words.start;
    }
    options.start = *start;
  }
  if (!words.g54.empty()) {
    options.g54_mm = position_of(words.g54);
    if (!options.g54_mm) {
      return "--g54 takes X,Y,Z in mm, as in --g54 120,80,-35.5; found " + words.g54;
    }
  }
  return std::nullopt;
}

// Which lines are meant.
std::optional<std::string> read_lines(const OptionWords& words, Options& options) {
  if (!words.explain_speed.empty()) {
    options.explained_speed = speed_question(words.explain_speed);
    if (!options.explained_speed) {
      return "--explain-speed takes a line or a time, as in --explain-speed=14 or =@1.5; found " +
             words.explain_speed;
    }
  }
  if (!words.from_line.empty()) {
    options.from_line = start_line_of(words.from_line);
    if (!options.from_line) {
      return "--from-line takes a line, as in --from-line 12, or 12:3 as it runs for the third "
             "time; found " +
             words.from_line;
    }
  }
  return std::nullopt;
}

// Reads the words into their options. What is wrong with them, as a sentence.
std::optional<std::string> give_meaning(OptionWords& words) {
  Options& options = words.options;
  if (makes_page(options.command)) {
    options.explained_speed.emplace();  // the page shows it
  } else if (options.command == Subcommand::compare) {
    options.explained_speed = SpeedQuestion{.each_line = true};
  }
  if (auto message = read_places(words, options)) {
    return message;
  }
  if (!words.block_delete.empty()) {
    const auto switches = block_delete_of(words.block_delete);
    if (!switches) {
      return "--block-delete takes numbers from 1 to 9, as in --block-delete=1,3; found " +
             words.block_delete;
    }
    options.block_delete = *switches;
  }
  if (auto message = read_lines(words, options)) {
    return message;
  }
  if (auto message = read_times(words, options)) {
    return message;
  }
  if (!words.max_trace.empty()) {
    const auto size = bytes_of(words.max_trace);
    if (!size) {
      return "--max-trace takes bytes, or a number with kB, MB, GB, TB, KiB, MiB, GiB or TiB; "
             "found " +
             words.max_trace;
    }
    options.max_trace_bytes = *size;
  }
  return std::nullopt;
}

}  // namespace

std::variant<Options, Leave> parse_options(int argc, const char* const* argv) {
  OptionWords words;
  CLI::App app(
      "Kerf: a motion kernel for CNC machines.\n"
      "Exit status: 0 done, 1 program error, 2 wrong use, 3 machine file error,\n"
      "4 limit or machine fault, 5 input or output failed, 6 defect of kerf,\n"
      "7 stopped on the path, 8 emergency stop,\n"
      "129 hung up, 130 interrupted, 143 terminated.",
      "kerf");
  app.set_version_flag("--version", "kerf " KERF_VERSION);
  app.require_subcommand(1);
  std::map<const CLI::App*, Subcommand> commands;
  const auto add = [&](Subcommand command, const std::string& description) {
    commands.emplace(add_command(app, command, description, words), command);
  };
  add(Subcommand::dry_run, "run on the simulated table without a clock");
  add(Subcommand::run, "run in real time");
  add(Subcommand::check, "read and plan only");
  const ErrorPageCommand error_pages(app);
  add(Subcommand::explain, "what is in force at a line of the program, and when");
  add(Subcommand::report, "run as dry-run does, into a page for the browser");
  add(Subcommand::view, "the same, shown in the browser");
  add(Subcommand::compare, "where the times of two programs differ, or of one on two machines");
  commands.emplace(add_tick_cost(app, words), Subcommand::tick_cost);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(error, out, err) == 0) {
      return Leave{.status = ExitStatus::done, .text = out.str()};
    }
    return wrong_use(error.what());
  }
  if (error_pages.chosen()) {
    const auto text = error_pages.text();
    return text ? Leave{.status = ExitStatus::done, .text = *text} : wrong_use(text.error());
  }
  Options& options = words.options;
  options.command = commands.at(app.get_subcommands().front());
  options.profile = *profiles::profile_kind(words.profile);
  if (options.continues && options.journal_file.empty()) {
    options.journal_file = options.files.front() + ".journal";
  }
  if (const auto message = give_meaning(words)) {
    return wrong_use(*message);
  }
  if (const auto message = contradiction(options)) {
    return wrong_use(*message);
  }
  return options;
}

}  // namespace kerf::program
