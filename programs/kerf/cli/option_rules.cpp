#include "programs/kerf/cli/option_rules.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "profiles/sigmoid.hpp"
#include "programs/kerf/cli/written_files.hpp"

namespace kerf::program {

namespace {

constexpr double kMinFeedOverride = 0.01;  // at 0 nothing would move
constexpr double kMaxFeedOverride = 2.0;

struct Unit {
  std::string_view name;
  double factor;
};
constexpr std::array kTimeUnits{Unit{"", 1.0}, Unit{"s", 1.0}, Unit{"min", 60.0}, Unit{"h", 3600.0},
                                Unit{"d", 86'400.0}};
constexpr std::array kSizeUnits{Unit{"", 1.0},       Unit{"B", 1.0},         Unit{"kB", 1e3},
                                Unit{"MB", 1e6},     Unit{"GB", 1e9},        Unit{"TB", 1e12},
                                Unit{"KiB", 1024.0}, Unit{"MiB", 1048576.0}, Unit{"GiB", 0x1p30},
                                Unit{"TiB", 0x1p40}};

// A plain decimal number and one of the units.
template <std::size_t kUnits>
std::optional<double> amount_of(std::string_view text, const std::array<Unit, kUnits>& units) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number, std::chars_format::fixed);
  if (read.ec != std::errc()) {
    return std::nullopt;
  }
  const std::string_view name(read.ptr, static_cast<std::size_t>(end - read.ptr));
  const auto unit = std::find_if(units.begin(), units.end(),
                                 [name](const Unit& known) { return known.name == name; });
  return unit == units.end() ? std::nullopt : std::optional(number * unit->factor);
}

}  // namespace

std::optional<double> duration_s_of(std::string_view text) {
  constexpr double kMax_s = 1e10;
  const auto time = amount_of(text, kTimeUnits);
  return time && *time >= 0.0 && *time <= kMax_s ? time : std::nullopt;
}

std::optional<std::uint64_t> bytes_of(std::string_view text) {
  constexpr double kMax = 0x1p60;
  const auto size = amount_of(text, kSizeUnits);
  if (!size || !(*size >= 1.0 && *size <= kMax)) {
    return std::nullopt;
  }
  return static_cast<std::uint64_t>(*size);
}

std::optional<parser::BlockDelete> block_delete_of(std::string_view text) {
  if (text == "all") {
    return parser::BlockDelete::all();
  }
  parser::BlockDelete switches;
  for (std::size_t at = 0; at < text.size() || at == 0; at += 2) {
    const bool number = at < text.size() && text[at] >= '1' && text[at] <= '9';
    if (!number || (at + 1 < text.size() && (text[at + 1] != ',' || at + 2 == text.size()))) {
      return std::nullopt;
    }
    switches.switch_on(static_cast<unsigned>(text[at] - '0'));
  }
  return switches;
}

std::optional<StartLine> start_line_of(std::string_view text) {
  StartLine start;
  const char* const end = text.data() + text.size();
  auto read = std::from_chars(text.data(), end, start.line);
  if (read.ec == std::errc() && read.ptr != end && *read.ptr == ':') {
    read = std::from_chars(read.ptr + 1, end, start.round);
  }
  const bool is_whole = read.ec == std::errc() && read.ptr == end;
  return is_whole && start.line > 0 && start.round > 0 ? std::optional(start) : std::nullopt;
}

namespace {

std::optional<std::string> contradiction_of_start(const Options& options) {
  if (options.from_line && options.continues) {
    return "--from-line and --continue name two places";
  }
  if (options.takes_safe_line && !options.from_line) {
    return "--safe-line goes with --from-line";
  }
  if (options.is_confirmed && !options.from_line && !options.continues) {
    return "--yes goes with --from-line or --continue";
  }
  if (options.from_line && options.files.size() > 1) {
    return "--from-line takes one FILE at a time";
  }
  const bool reads_twice = options.from_line || !options.journal_file.empty();
  if (reads_twice && !options.files.empty() && options.files.front() == "-") {
    return "--from-line, --journal and --continue take a FILE: standard input is read only once";
  }
  return std::nullopt;
}

std::optional<std::string> contradiction_of_control(const Options& options) {
  const std::string where = options.control.value_or("");
  if (where.empty() || where.front() < '0' || where.front() > '9') {
    return std::nullopt;  // a path
  }
  const bool reads_input = where == "0" || where.starts_with("0,");
  const bool writes_output = where == "1" || where.ends_with(",1");
  if (reads_input && options.files.front() == "-") {
    return "standard input can be read only once";
  }
  if (writes_output && (!options.quiet || options.json || options.trace_file == "-")) {
    return "--control on standard output goes with --quiet, and with neither --json nor --trace -";
  }
  return std::nullopt;
}

std::optional<std::string> contradiction_of_streams(const Options& options) {
  if (options.page_file == "-" && options.json) {
    return "--json and -o - both write to standard output";
  }
  if (options.plot_file == "-" && (options.json || options.trace_file == "-")) {
    return "--plot - writes to standard output, as --json and --trace - do";
  }
  const auto from_input = std::count(options.files.begin(), options.files.end(), "-");
  const bool runs_twice = options.machine_files.size() > 1 &&
                          (options.command != Subcommand::compare || options.files.size() == 1);
  if (from_input > 1 || (from_input == 1 && runs_twice)) {
    return "standard input can be read only once";
  }
  return std::nullopt;
}

std::optional<std::string> contradiction_of_files(const Options& options) {
  return written_over(options, {});
}

std::optional<std::string> contradiction_of_comparison(const Options& options) {
  if (options.command != Subcommand::compare) {
    return std::nullopt;
  }
  if (options.machine_files.size() > 2) {
    return "compare takes at most two machines";
  }
  const std::size_t files = options.files.size();
  if (files > 2 || (files < 2 && options.machine_files.size() < 2)) {
    return "compare takes two FILEs, or one and --machine twice";
  }
  return std::nullopt;
}

std::optional<std::string> contradiction_of_trace(const Options& options) {
  const Options usual;
  const bool chooses_ticks =
      options.trace_every != usual.trace_every || options.trace_from_s != usual.trace_from_s ||
      options.trace_to_s != usual.trace_to_s || options.max_trace_bytes != usual.max_trace_bytes;
  if (chooses_ticks && !options.trace_file) {
    return "--trace-every, --trace-from, --trace-to and --max-trace go with --trace";
  }
  if (options.trace_from_s > options.trace_to_s) {
    return "--trace-from is later than --trace-to";
  }
  if (options.json && options.trace_file == "-") {
    return "--json and --trace - both write to standard output";
  }
  return std::nullopt;
}

std::optional<std::string> contradiction_of_profile(const Options& options) {
  using profiles::Sigmoid;
  if (options.sigmoid_shape && options.profile != profiles::ProfileKind::sigmoid) {
    return "--sigmoid-shape goes with --profile sigmoid";
  }
  // Not CLI::Range: it lets NaN pass.
  if (options.sigmoid_shape && !(*options.sigmoid_shape >= Sigmoid::kSmallestShape &&
                                 *options.sigmoid_shape <= Sigmoid::kLargestShape)) {
    return fmt::format("--sigmoid-shape: s is to be {} to {}", Sigmoid::kSmallestShape,
                       Sigmoid::kLargestShape);
  }
  return std::nullopt;
}

std::optional<std::string> contradiction_of_override(const Options& options) {
  if (!(options.feed_override >= kMinFeedOverride && options.feed_override <= kMaxFeedOverride)) {
    return fmt::format("--feed-override: {:.0f} to {:.0f} percent", 100.0 * kMinFeedOverride,
                       100.0 * kMaxFeedOverride);
  }
  return std::nullopt;
}

std::optional<std::string> contradiction_of_outputs(const Options& options) {
  const bool records = !options.record_file.empty() || !options.replay_file.empty();
  if (options.files.size() > 1 && (options.trace_file || options.plot_file || records)) {
    return "--trace, --plot, --record and --replay take one FILE at a time";
  }
  if (!options.driver_name.empty() && !options.replay_file.empty()) {
    return "--driver and --replay name two machines";
  }
  if (options.json && options.command == Subcommand::check &&
      options.format != DiagnosticFormat::text) {
    return "--json and --format both write to standard output";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> contradiction(const Options& options) {
  for (const auto find :
       {contradiction_of_outputs, contradiction_of_comparison, contradiction_of_trace,
        contradiction_of_profile, contradiction_of_override, contradiction_of_streams,
        contradiction_of_files, contradiction_of_start, contradiction_of_control}) {
    if (auto message = find(options)) {
      return message;
    }
  }
  return std::nullopt;
}

}  // namespace kerf::program
