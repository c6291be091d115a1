#include "programs/kerf/run/check_pass.hpp"

#include <algorithm>
#include <optional>

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/io/progress.hpp"
#include "programs/kerf/io/progress_bar.hpp"

namespace kerf::program {

tl::expected<CheckReport, std::string> check_pass(ProgramFile& file,
                                                  const MachineSettings& settings,
                                                  const KernelOptions& kernel_options,
                                                  const CheckPassOptions& options) {
  Progress progress;
  const ProgressBar bar([] { return std::string("checking"); },
                        [&] { return progress.read_share(); }, options.shows_progress);
  std::optional<std::string> error;
  const auto size = static_cast<double>(std::max<std::uint64_t>(file.size_bytes(), 1));
  const TextSource text = [&]() -> std::string_view {
    if (stop_requested()) {
      return {};
    }
    const auto piece = file.read();
    if (!piece) {
      error = piece.error();
      return {};
    }
    progress.set_read(static_cast<double>(file.bytes_read()) / size);
    return *piece;
  };
  const auto check = options.syntax_only ? check_syntax : check_program;
  CheckReport report = check(text, settings, kernel_options,
                             {.stop = [] { return stop_requested().has_value(); },
                              .max_time_s = options.max_time_s,
                              .max_moves = options.max_moves,
                              .starts_at_first_places = options.starts_at_first_places});
  if (error) {
    return tl::unexpected(*error);
  }
  return report;
}

}  // namespace kerf::program
