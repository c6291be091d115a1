#include "programs/kerf/cli/option_parser.hpp"

#include <map>
#include <sstream>
#include <string_view>

#include <CLI/CLI.hpp>

#include "kernel/settings_check.hpp"
#include "programs/kerf/cli/error_page_text.hpp"
#include "programs/kerf/cli/option_rules.hpp"
#include "programs/kerf/io/visible_text.hpp"

namespace kerf::program {

namespace {

const std::map<std::string, DiagnosticFormat> kFormats{{"text", DiagnosticFormat::text},
                                                       {"json", DiagnosticFormat::json},
                                                       {"sarif", DiagnosticFormat::sarif}};

const std::map<std::string, LogLevel> kLogLevels{
    {"debug", LogLevel::debug}, {"info", LogLevel::info}, {"error", LogLevel::error}};

std::vector<std::string> profile_names() {
  std::vector<std::string> names;
  for (auto kind = 0U; kind <= static_cast<unsigned>(ProfileKind::time_optimal); ++kind) {
    names.emplace_back(name_of(static_cast<ProfileKind>(kind)));
  }
  return names;
}

// What the options of all commands are read into before they mean something.
struct Raw {
  Options options;
  std::string profile{name_of(profiles::kDefaultProfile)};
  std::string block_delete;   // empty: not given
  std::string explain_speed;  // the same
  std::string max_time;       // the same
  std::string max_trace;      // the same
};

void add_machine(CLI::App& command, Options& options) {
  command.add_option("--machine", options.machine_file, "machine file (default: a small mill)")
      ->type_name("FILE.toml");
}

void add_common(CLI::App& command, Raw& raw) {
  Options& options = raw.options;
  command
      .add_option("--tools", options.tool_file, "tool table (default: that of the machine file)")
      ->type_name("FILE");
  command.add_option("--profile", raw.profile, "feedrate profile")
      ->check(CLI::IsMember(profile_names()))
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--sigmoid-shape", options.sigmoid_shape,
                  "shape s of the sigmoid (default: chosen for each transition)")
      ->type_name("S");
  command.add_option("--window", options.window_blocks, "blocks that the look-ahead sees")
      ->check(CLI::Range(std::size_t{2}, std::size_t{kMaxWindowBlocks}))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--dialect",
          [&options](const std::string& name) {
            options.dialect = name == "fanuc" ? parser::Dialect::fanuc : parser::Dialect::rs274;
          },
          "language of the program: rs274 or fanuc (default: that of the machine file)")
      ->check(CLI::IsMember({"rs274", "fanuc"}))
      ->type_name("NAME");
  command.add_flag(
      "--block-delete{all}", raw.block_delete,
      "leave out blocks that begin with /, or with =1,3 those with / (which is /1) and "
      "/3");
  command
      .add_option("--max-time", raw.max_time,
                  "machine time that the program may take: 90, 90s, 5min, 2h, 30d (default: 30d)")
      ->type_name("TIME");
  command
      .add_option("--max-moves", options.max_moves,
                  "how many moves the program may have, loops included (default: 100000000)")
      ->type_name("N");
  command.add_flag("--json", options.json, "report as JSON on standard output");
  command
      .add_option("--format", options.format,
                  "errors and warnings as text, json or sarif (check: on standard output)")
      ->transform(CLI::CheckedTransformer(kFormats).description("{text,json,sarif}"))
      ->type_name("NAME");
  command
      .add_option("--log-level", options.log_level,
                  "messages: error, info or debug, which tells how the motion is planned "
                  "(default: info)")
      ->transform(CLI::CheckedTransformer(kLogLevels).description("{error,info,debug}"))
      ->type_name("NAME");
  command
      .add_option("--log", options.log_file,
                  "file that gets the messages with the time before them, too")
      ->type_name("FILE");
  command.add_flag("-q,--quiet", options.quiet, "no summary, no progress bar, no warnings");
}

void add_outputs(CLI::App& command, Raw& raw) {
  Options& options = raw.options;
  command
      .add_option("--trace", options.trace_file, "write one row per tick (- is standard output)")
      ->type_name("FILE.csv");
  command
      .add_option("--max-trace", raw.max_trace,
                  "size that the trace may have: 1000, 500MB, 4GiB (default: 4GiB)")
      ->type_name("SIZE");
  command.add_option("--plot", options.plot_file, "draw the path and v, a, j over time")
      ->type_name("FILE.svg");
  command.add_flag("--explain-speed{all}", raw.explain_speed,
                   "which limits bound the feedrate, and for how long; with =14 for line 14, "
                   "with =@1.5 at 1.5 s");
}

void add_page(CLI::App& command, Command which, Options& options) {
  command
      .add_option("--machine", options.machine_files,
                  "machine file (default: a small mill); several stand side by side")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("FILE.toml");
  if (which == Command::report) {
    command.add_option("-o,--output", options.page_file, "the page to write")
        ->required()
        ->type_name("FILE.html");
  }
  command.add_flag("--no-source", options.leaves_out_source,
                   "leave the program's text out of the page");
  command
      .add_option("--page", options.page_template,
                  "the page without data (default: page.html beside kerf, or as installed)")
      ->type_name("FILE.html");
}

CLI::App* add_command(CLI::App& app, Command command, const std::string& description, Raw& raw) {
  CLI::App* added = app.add_subcommand(std::string(name_of(command)), description);
  CLI::Option* files =
      added->add_option("FILE", raw.options.files, "part program (- is standard input)")
          ->required()
          ->type_name("");
  if (command == Command::run || command == Command::explain) {
    files->expected(1);
  }
  if (makes_page(command)) {
    add_page(*added, command, raw.options);
  } else {
    add_machine(*added, raw.options);
  }
  add_common(*added, raw);
  if (command == Command::explain) {
    added->add_option("--line", raw.options.explained_line, "the line to explain")
        ->required()
        ->check(CLI::PositiveNumber)
        ->type_name("N");
  } else if (command == Command::check) {
    added->add_flag("--syntax", raw.options.syntax_only,
                    "read the text alone: no plan, no curves, no travel");
  } else if (!makes_page(command)) {
    add_outputs(*added, raw);
  }
  if (command == Command::run) {
    added->add_flag("--optional-stop", raw.options.optional_stop, "M1 waits, as M0 does");
    added
        ->add_option("--control", raw.options.control,
                     "commands in and events out as JSON lines: 3, a descriptor; 4,5, one to read "
                     "and one to write; else the path of a socket to make")
        ->type_name("WHERE");
  }
  return added;
}

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

// Reads the words of raw into its options. What is wrong with them, as a sentence.
std::optional<std::string> give_meaning(Raw& raw) {
  Options& options = raw.options;
  if (makes_page(options.command)) {
    options.explained_speed.emplace();  // the page shows it
  }
  if (!raw.block_delete.empty()) {
    const auto switches = block_delete_of(raw.block_delete);
    if (!switches) {
      return "--block-delete takes numbers from 1 to 9, as in --block-delete=1,3; found " +
             raw.block_delete;
    }
    options.block_delete = *switches;
  }
  if (!raw.explain_speed.empty()) {
    options.explained_speed = speed_question(raw.explain_speed);
    if (!options.explained_speed) {
      return "--explain-speed takes a line or a time, as in --explain-speed=14 or =@1.5; found " +
             raw.explain_speed;
    }
  }
  if (!raw.max_time.empty()) {
    const auto time = duration_s_of(raw.max_time);
    if (!time) {
      return "--max-time takes seconds, or a number with s, min, h or d; found " + raw.max_time;
    }
    options.max_time_s = *time;
  }
  if (!raw.max_trace.empty()) {
    const auto size = bytes_of(raw.max_trace);
    if (!size) {
      return "--max-trace takes bytes, or a number with kB, MB, GB, TB, KiB, MiB, GiB or TiB; "
             "found " +
             raw.max_trace;
    }
    options.max_trace_bytes = *size;
  }
  return std::nullopt;
}

}  // namespace

std::variant<Options, Leave> parse_options(int argc, const char* const* argv) {
  Raw raw;
  CLI::App app(
      "Kerf: a motion kernel for CNC machines.\n"
      "Exit status: 0 done, 1 program error, 2 wrong use, 3 machine file error,\n"
      "4 limit or machine fault, 5 input or output failed, 6 defect of kerf,\n"
      "7 stopped at the terminal, 8 emergency stop,\n"
      "129 hung up, 130 interrupted, 143 terminated.",
      "kerf");
  app.set_version_flag("--version", "kerf " KERF_VERSION);
  app.require_subcommand(1);
  std::map<const CLI::App*, Command> commands;
  const auto add = [&](Command command, const std::string& description) {
    commands.emplace(add_command(app, command, description, raw), command);
  };
  add(Command::dry_run, "run on the simulated table without a clock");
  add(Command::run, "run in real time");
  add(Command::check, "read and plan only");
  const ErrorPageCommand error_pages(app);
  add(Command::explain, "what is in force at a line of the program, and when");
  add(Command::report, "run as dry-run does, into a page for the browser");
  add(Command::view, "the same, shown in the browser");
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
  Options& options = raw.options;
  options.command = commands.at(app.get_subcommands().front());
  options.profile = *profiles::profile_kind(raw.profile);
  if (const auto message = give_meaning(raw)) {
    return wrong_use(*message);
  }
  if (const auto message = contradiction(options)) {
    return wrong_use(*message);
  }
  return options;
}

}  // namespace kerf::program
