// The files that a run writes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/io/output_file.hpp"
#include "programs/kerf/options.hpp"
#include "programs/kerf/plot/svg_plot.hpp"
#include "programs/kerf/run/recorder.hpp"

namespace kerf::program {

class OutputFiles {
 public:
  // Call it before anything moves, so that errors of writing are known by then. extents: of what
  // the plot is to show.
  static tl::expected<OutputFiles, std::string> open(const Options& options,
                                                     const MachineSettings& settings,
                                                     const curves::Extents& extents);

  [[nodiscard]] Recorder& recorder() noexcept { return recorder_; }

  // An earlier run did not end as it should, and left this behind.
  [[nodiscard]] std::vector<std::string> warnings() const;

  // After the motion: end the trace and draw the plot. Return the error, if there was one. dropped:
  // ticks that the recorder never saw. is_cut: the run has ended before its program, so the file
  // keeps the name of an incomplete one.
  std::optional<std::string> close_trace(std::uint64_t dropped, bool is_cut);
  std::optional<std::string> write_plot(const PlotCaption& caption, bool is_cut);

 private:
  OutputFiles() = default;

  Recorder recorder_;
  std::optional<OutputFile> plot_file_;
};

}  // namespace kerf::program
