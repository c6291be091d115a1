#include "programs/option_rules.hpp"

#include <algorithm>

#include <spdlog/fmt/fmt.h>

#include "profiles/sigmoid.hpp"

namespace kerf::program {

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

std::optional<std::string> contradiction(const Options& options) {
  if (options.files.size() > 1 && (options.trace_file || options.plot_file)) {
    return "--trace and --plot take one FILE at a time";
  }
  if (options.json && options.trace_file == "-") {
    return "--json and --trace - both write to standard output";
  }
  if (options.json && options.command == Command::check &&
      options.format != DiagnosticFormat::text) {
    return "--json and --format both write to standard output";
  }
  if (options.sigmoid_shape && options.profile != profiles::ProfileKind::sigmoid) {
    return "--sigmoid-shape goes with --profile sigmoid";
  }
  // Not CLI::Range: it lets NaN pass.
  using profiles::Sigmoid;
  if (options.sigmoid_shape && !(*options.sigmoid_shape >= Sigmoid::kSmallestShape &&
                                 *options.sigmoid_shape <= Sigmoid::kLargestShape)) {
    return fmt::format("--sigmoid-shape: s is to be {} to {}", Sigmoid::kSmallestShape,
                       Sigmoid::kLargestShape);
  }
  if (std::count(options.files.begin(), options.files.end(), "-") > 1) {
    return "standard input can be read only once";
  }
  return std::nullopt;
}

}  // namespace kerf::program
