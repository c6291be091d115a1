#include "programs/outputs.hpp"

#include <utility>

#include "programs/number_text.hpp"

namespace kerf::program {

tl::expected<Outputs, std::string> Outputs::open(const Options& options,
                                                 const MachineSettings& settings,
                                                 const curves::Extents& extents) {
  Outputs outputs;
  if (options.trace_file) {
    auto trace = TraceWriter::create(*options.trace_file, settings.limits.period_s,
                                     {.axes = extra_axes(settings.program.extra_axes),
                                      .limit = options.explained_speed.has_value()});
    if (!trace) {
      return tl::unexpected(trace.error());
    }
    outputs.recorder_.trace.emplace(std::move(*trace));
  }
  if (options.plot_file) {
    auto plot = PlotFile::create(*options.plot_file);
    if (!plot) {
      return tl::unexpected(plot.error());
    }
    outputs.plot_file_.emplace(std::move(*plot));
    outputs.recorder_.plot.emplace(extents);
    if (options.explained_speed) {
      outputs.recorder_.plot->add_limits();
    }
  }
  if (options.explained_speed) {
    outputs.recorder_.speed.emplace(*options.explained_speed, settings.limits.period_s);
  }
  return outputs;
}

std::optional<std::string> Outputs::close_trace(std::uint64_t dropped) {
  if (!recorder_.trace) {
    return std::nullopt;
  }
  recorder_.trace->close();
  if (const auto& error = recorder_.trace->error()) {
    return *error + "; the trace is incomplete";
  }
  if (dropped > 0) {
    return "the trace lacks " + counted(dropped, "tick") + ": writing it was too slow";
  }
  return std::nullopt;
}

std::optional<std::string> Outputs::write_plot(const PlotCaption& caption) {
  if (!plot_file_) {
    return std::nullopt;
  }
  const auto written = plot_file_->write(svg_plot(*recorder_.plot, caption));
  return written ? std::nullopt : std::optional(written.error());
}

}  // namespace kerf::program
