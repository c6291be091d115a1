#include "programs/kerf/cli/option_list.hpp"

#include <map>
#include <vector>

#include "kernel/settings_check.hpp"

namespace kerf::program {

namespace {

// Moves, lines, ticks: more than anybody asks for.
constexpr std::int64_t kMaxCounted = 1'000'000'000'000;

const std::map<std::string, DiagnosticFormat> kFormats{{"text", DiagnosticFormat::text},
                                                       {"json", DiagnosticFormat::json},
                                                       {"sarif", DiagnosticFormat::sarif}};

const std::map<std::string, LogLevel> kLogLevels{
    {"debug", LogLevel::debug}, {"info", LogLevel::info}, {"error", LogLevel::error}};

const std::map<std::string, parser::Dialect> kDialects{{"fanuc", parser::Dialect::fanuc},
                                                       {"rs274", parser::Dialect::rs274}};

const std::map<std::string, FeedUnit> kFeedUnits{
    {"mm/s", FeedUnit::mm_s}, {"mm/min", FeedUnit::mm_min}, {"inch/min", FeedUnit::inch_min}};

// An empty word, as of an unset variable, is no value.
CLI::Validator something() {
  return {[](std::string& word) { return std::string(word.empty() ? "a value is missing" : ""); },
          ""};
}

// For a word that stands for a value. CLI::CheckedTransformer would name the values as numbers.
template <typename Target, typename Value>
auto setter(Target& target, const std::map<std::string, Value>& values) {
  return [&target, &values](const std::string& word) { target = values.at(word); };
}

std::vector<std::string> profile_names() {
  std::vector<std::string> names;
  for (auto kind = 0U; kind <= static_cast<unsigned>(ProfileKind::time_optimal); ++kind) {
    names.emplace_back(name_of(static_cast<ProfileKind>(kind)));
  }
  return names;
}

void add_machine(CLI::App& command, Options& options) {
  command.add_option("--machine", options.machine_file, "machine file (default: a small mill)")
      ->type_name("FILE.toml");
}

void add_messages(CLI::App& command, Options& options) {
  command.add_flag("--json", options.json, "report as JSON on standard output");
  command
      .add_option_function<std::string>(
          "--format", setter(options.format, kFormats),
          "errors and warnings as text, json or sarif (check: on standard output)")
      ->check(CLI::IsMember(kFormats))
      ->type_name("NAME");
  command
      .add_option_function<std::string>(
          "--log-level", setter(options.log_level, kLogLevels),
          "messages: error, info or debug, which tells how the motion is planned (default: info)")
      ->check(CLI::IsMember(kLogLevels))
      ->type_name("NAME");
  command
      .add_option("--log", options.log_file,
                  "file that gets the messages with the time before them, too")
      ->type_name("FILE");
  command.add_flag("-q,--quiet", options.quiet, "no summary, no progress bar, no warnings");
}

void add_common(CLI::App& command, OptionWords& words) {
  Options& options = words.options;
  command
      .add_option("--tools", options.tool_file, "tool table (default: that of the machine file)")
      ->check(something())
      ->type_name("FILE");
  command.add_option("--profile", words.profile, "feedrate profile")
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
          "--dialect", setter(options.dialect, kDialects),
          "language of the program: rs274 or fanuc (default: that of the machine file)")
      ->check(CLI::IsMember(kDialects))
      ->type_name("NAME");
  command.add_flag(
      "--block-delete{all}", words.block_delete,
      "leave out blocks that begin with /, or with =1,3 those with / (which is /1) and "
      "/3");
  command
      .add_option("--max-time", words.max_time,
                  "machine time that the program may take: 90, 90s, 5min, 2h, 30d (default: 30d)")
      ->check(something())
      ->type_name("TIME");
  command
      .add_option("--max-moves", options.max_moves,
                  "how many moves the program may have, loops included (default: 100000000)")
      ->check(CLI::Range(std::int64_t{1}, kMaxCounted))
      ->type_name("N");
  command
      .add_option("--start", words.start,
                  "where the tool is at the start, on the machine in mm, or first-move: where the "
                  "first moves lead (default: 0,0,0)")
      ->check(something())
      ->type_name("X,Y,Z");
  command
      .add_option("--g54", words.g54,
                  "origin of G54 on the machine in mm (default: that of the machine file)")
      ->check(something())
      ->type_name("X,Y,Z");
  command
      .add_option_function<std::string>(
          "--units", setter(options.feed_unit, kFeedUnits),
          "unit of feedrates beside mm/s (default: that of the program, by G20 or G21)")
      ->check(CLI::IsMember(kFeedUnits))
      ->type_name("UNIT");
  add_messages(command, options);
}

void add_outputs(CLI::App& command, OptionWords& words) {
  Options& options = words.options;
  command
      .add_option("--trace", options.trace_file,
                  "write one row per tick (- is standard output; NAME.npy: an array of NumPy)")
      ->type_name("FILE.csv");
  command
      .add_option("--trace-every", options.trace_every,
                  "a row for every so many-th tick (default: 1)")
      ->check(CLI::Range(std::int64_t{1}, kMaxCounted))
      ->type_name("N");
  command.add_option("--trace-from", words.trace_from, "no row before: 90, 90s, 5min")
      ->check(something())
      ->type_name("TIME");
  command.add_option("--trace-to", words.trace_to, "no row after: 90, 90s, 5min")
      ->check(something())
      ->type_name("TIME");
  command
      .add_option("--max-trace", words.max_trace,
                  "size that the trace may have: 1000, 500MB, 4GiB (default: 4GiB)")
      ->check(something())
      ->type_name("SIZE");
  command
      .add_option("--record", options.record_file,
                  "write what the machine is told and answers, tick by tick")
      ->check(something())
      ->type_name("FILE");
  command
      .add_option("--replay", options.replay_file,
                  "the machine answers as in this record, and is to be told the same")
      ->check(something())
      ->type_name("FILE");
  command.add_option("--plot", options.plot_file, "draw the path and v, a, j over time")
      ->type_name("FILE.svg");
  command
      .add_option("--from-line", words.from_line,
                  "start at this line: 12, or 12:3 as it runs for the third time")
      ->check(something())
      ->type_name("N");
  command.add_flag("--safe-line", options.takes_safe_line,
                   "where one cannot start at that line, start at the nearest before it");
  command.add_flag("--explain-speed{all}", words.explain_speed,
                   "which limits bound the feedrate, and for how long; with =14 for line 14, "
                   "with =@1.5 at 1.5 s");
}

void add_feed_override(CLI::App& command, Options& options) {
  command
      .add_option_function<double>(
          "--feed-override",
          [&options](double percent) { options.feed_override = percent / 100.0; },
          "share of the programmed feedrates that is run, 1 to 200 percent (default: 100)")
      ->type_name("PERCENT");
}

void add_machines(CLI::App& command, const std::string& description, Options& options) {
  command.add_option("--machine", options.machine_files, description)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("FILE.toml");
}

void add_comparison(CLI::App& command, Options& options) {
  add_machines(command, "machine file (default: a small mill); given twice, the second's", options);
  command
      .add_option("--lines", options.compared_lines,
                  "how many of the lines that differ most are named")
      ->check(CLI::Range(std::int64_t{0}, kMaxCounted))
      ->type_name("N")
      ->capture_default_str();
}

void add_page(CLI::App& command, Subcommand which, Options& options) {
  add_machines(command, "machine file (default: a small mill); several stand side by side",
               options);
  if (which == Subcommand::report) {
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

void add_realtime(CLI::App& command, Options& options) {
  command.add_flag("--realtime", options.realtime,
                   "ticks before all else: SCHED_FIFO, locked memory, one processor; says what is "
                   "not permitted");
}

void add_run(CLI::App& command, Options& options) {
  command
      .add_option("--driver", options.driver_name,
                  "what takes the setpoints (default: that of the machine file)")
      ->check(CLI::IsMember(std::vector<std::string>(kDriverNames.begin(), kDriverNames.end())))
      ->type_name("NAME");
  add_realtime(command, options);
  command.add_flag("--home", options.homes, "find the home switches before the program");
  command.add_flag("--wait-start", options.waits_for_start,
                   "the program waits for start: until then MDI, jog and home");
  command
      .add_option("--flight-recorder", options.flight_file,
                  "after a fault: the ticks of its last 5 s, as --trace has them")
      ->check(something())
      ->type_name("FILE.csv");
  command
      .add_option("--journal", options.journal_file,
                  "keep there how far the run has come, once a second")
      ->check(something())
      ->type_name("FILE");
  command.add_flag("--continue", options.continues,
                   "go on where the journal ends (default: that of --journal, else FILE.journal)");
  command.add_flag("--yes", options.is_confirmed, "start at the line without being asked");
  command.add_flag("--optional-stop", options.optional_stop, "M1 waits, as M0 does");
  command
      .add_option("--control", options.control,
                  "commands in and events out as JSON lines: 3, a descriptor; 4,5, one to read "
                  "and one to write; else the path of a socket to make")
      ->type_name("WHERE");
}

}  // namespace

CLI::App* add_command(CLI::App& app, Subcommand command, const std::string& description,
                      OptionWords& words) {
  CLI::App* added = app.add_subcommand(std::string(name_of(command)), description);
  CLI::Option* files =
      added->add_option("FILE", words.options.files, "part program (- is standard input)")
          ->required()
          ->type_name("");
  if (command == Subcommand::run || command == Subcommand::explain) {
    files->expected(1);
  }
  if (command == Subcommand::compare) {
    add_comparison(*added, words.options);
  } else if (makes_page(command)) {
    add_page(*added, command, words.options);
  } else {
    add_machine(*added, words.options);
  }
  add_common(*added, words);
  if (command == Subcommand::explain) {
    added->add_option("--line", words.options.explained_line, "the line to explain")
        ->required()
        ->check(CLI::Range(std::int64_t{1}, kMaxCounted))
        ->type_name("N");
  } else if (command == Subcommand::check) {
    added->add_flag("--syntax", words.options.syntax_only,
                    "read the text alone: no plan, no curves, no travel");
  } else if (command == Subcommand::dry_run || command == Subcommand::run) {
    add_outputs(*added, words);
  }
  if (command == Subcommand::run) {
    add_run(*added, words.options);
  } else if (command != Subcommand::check && command != Subcommand::explain) {
    add_feed_override(*added, words.options);
  }
  return added;
}

CLI::App* add_tick_cost(CLI::App& app, OptionWords& words) {
  CLI::App* added =
      app.add_subcommand(std::string(name_of(Subcommand::tick_cost)),
                         "what a tick costs on this computer, and which period it bears");
  add_machine(*added, words.options);
  add_realtime(*added, words.options);
  added
      ->add_option("--time", words.measured,
                   "how long to measure at least: 90, 90s, 5min (default: 5s)")
      ->type_name("TIME");
  added->add_flag("--json", words.options.json, "the figures as JSON");
  return added;
}

}  // namespace kerf::program
