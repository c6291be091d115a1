#include "programs/kerf/run/output_files.hpp"

#include <utility>

#include "programs/kerf/io/number_text.hpp"

namespace kerf::program {

tl::expected<OutputFiles, std::string> OutputFiles::open(const Options& options,
                                                         const MachineSettings& settings,
                                                         const curves::Extents& extents) {
  OutputFiles outputs;
  if (options.trace_file) {
    auto trace = TraceWriter::create(*options.trace_file,
                                     {.period_s = settings.limits.period_s,
                                      .columns = {.axes = extra_axes(settings.program.extra_axes),
                                                  .limit = options.explained_speed.has_value()},
                                      .ticks = {.every = options.trace_every,
                                                .from_s = options.trace_from_s,
                                                .to_s = options.trace_to_s},
                                      .max_bytes = options.max_trace_bytes});
    if (!trace) {
      return tl::unexpected(trace.error());
    }
    outputs.recorder_.trace.emplace(std::move(*trace));
  }
  if (options.plot_file) {
    auto plot = OutputFile::create(*options.plot_file);
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

std::vector<std::string> OutputFiles::warnings() const {
  std::vector<std::string> warnings;
  const auto look_at = [&warnings](const OutputFile& file) {
    if (file.follows_incomplete()) {
      warnings.push_back("an earlier run did not end cleanly: its " + file.name() +
                         ".incomplete is replaced");
    }
  };
  if (recorder_.trace) {
    look_at(recorder_.trace->file());
  }
  if (plot_file_) {
    look_at(*plot_file_);
  }
  return warnings;
}

std::optional<std::string> OutputFiles::close_trace(std::uint64_t dropped, bool is_cut) {
  if (!recorder_.trace) {
    return std::nullopt;
  }
  recorder_.trace->close(dropped > 0 || is_cut);
  if (const auto& error = recorder_.trace->error()) {
    return *error + "; the trace is incomplete" + recorder_.trace->remains();
  }
  if (dropped > 0) {
    return "the trace lacks " + counted(dropped, "tick") + ": writing it was too slow" +
           recorder_.trace->remains();
  }
  return std::nullopt;
}

std::optional<std::string> OutputFiles::write_plot(const PlotCaption& caption, bool is_cut) {
  if (!plot_file_) {
    return std::nullopt;
  }
  int error = plot_file_->write(svg_plot(*recorder_.plot, caption));
  if (const int closing = plot_file_->finish(error == 0 && !is_cut); error == 0) {
    error = closing;
  }
  if (error == 0) {
    return std::nullopt;
  }
  return plot_file_->name() + ": " + error_text(error) + "; the plot is incomplete" +
         plot_file_->remains();
}

}  // namespace kerf::program
