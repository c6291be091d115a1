// The options of the command line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <kerf/program_data.hpp>

#include "kernel/driver_settings.hpp"
#include "parser/dialects/dialect.hpp"
#include "parser/flow/reader_options.hpp"
#include "profiles/profile.hpp"
#include "programs/kerf/feed_unit.hpp"
#include "programs/kerf/speed_question.hpp"
#include "programs/kerf/start_place.hpp"

namespace kerf::program {

enum class Subcommand : unsigned char {
  dry_run,
  run,
  check,
  explain,
  report,
  view,
  compare,
  tick_cost
};

std::string_view name_of(Subcommand command) noexcept;
[[nodiscard]] bool makes_page(Subcommand command) noexcept;

// How errors and warnings are written: for people, or as one document for programs.
enum class DiagnosticFormat : unsigned char { text, json, sarif };

// Which messages are written; debug: how the motion is planned, too.
enum class LogLevel : unsigned char { debug, info, error };

// A line of a program, the first time that it runs, or the second and so on.
struct StartLine {
  std::uint32_t line = 0;
  std::uint64_t round = 1;
};

struct Options {
  Subcommand command = Subcommand::dry_run;
  std::vector<std::string> files;
  std::optional<std::string> machine_file;
  // Of Subcommand::report and view: each with all FILEs. Of compare: one for both, or one each.
  std::vector<std::string> machine_files;
  std::size_t compared_lines = 10;  // of Subcommand::compare: how many it names
  std::optional<std::string> tool_file;
  StartPlace start{};              // machine zero, unless told otherwise
  std::optional<Position> g54_mm;  // in place of the machine's
  std::string driver_name;         // of Subcommand::run; empty: that of the machine file
  DriverSettings driver;
  std::uint64_t machine_checksum = 0;  // of the machine file, what it names, and --g54
  std::string record_file;             // of what the machine is told and answers; empty: none
  std::string replay_file;             // the machine answers as this one says; empty: it does not
  profiles::ProfileKind profile = profiles::kDefaultProfile;
  std::optional<double> sigmoid_shape;
  double feed_override = 1.0;  // of all commands that move but run, whose operator gives it
  std::optional<std::string> trace_file;
  std::optional<std::string> plot_file;
  std::optional<std::string> flight_file;  // what was before a fault
  double max_time_s = 30.0 * 86'400.0;     // of machine time that a program may take
  std::uint64_t max_moves = 100'000'000;
  std::uint64_t max_trace_bytes = std::uint64_t{4} << 30U;
  std::int64_t trace_every = 1;  // ticks; > 0
  double trace_from_s = 0.0;
  double trace_to_s = std::numeric_limits<double>::infinity();
  std::size_t window_blocks = 1000;
  std::uint32_t explained_line = 0;  // of Subcommand::explain
  std::optional<SpeedQuestion> explained_speed;
  DiagnosticFormat format = DiagnosticFormat::text;
  std::optional<parser::Dialect> dialect;  // nothing: that of the machine file
  parser::BlockDelete block_delete;
  bool syntax_only = false;            // of Subcommand::check
  bool realtime = false;               // of Subcommand::run and tick_cost
  bool optional_stop = false;          // of Subcommand::run
  bool homes = false;                  // the same: before the program
  bool waits_for_start = false;        // the same
  std::optional<std::string> control;  // of Subcommand::run: a descriptor, two of them, or a socket
  double measured_s = 5.0;             // of Subcommand::tick_cost
  std::optional<StartLine> from_line;  // of Subcommand::run and dry_run; nothing: the begin
  std::string journal_file;            // of Subcommand::run; empty: none
  bool continues = false;              // from where the journal says
  bool takes_safe_line = false;        // where one cannot start there, the line before
  bool is_confirmed = false;           // nobody is asked whether to start there
  std::string page_file;               // of Subcommand::report: where the page goes
  std::optional<std::string> page_template;  // of Subcommand::report and view
  bool leaves_out_source = false;            // the same
  std::optional<FeedUnit> feed_unit;         // beside mm/s; nothing: that of the program
  LogLevel log_level = LogLevel::info;
  std::optional<std::string> log_file;  // nothing: standard error
  bool json = false;
  bool quiet = false;
};

}  // namespace kerf::program
