#include "programs/kerf/run/plan_only.hpp"

#include <algorithm>
#include <vector>

#include "kernel/pipeline.hpp"
#include "programs/kerf/io/interrupt.hpp"

namespace kerf::program {

namespace {

// The line in which that much time is over.
std::optional<std::uint32_t> line_past(double time_s, const lookahead::Outbox& outbox,
                                       double period_s) {
  for (const interp::Phase& phase : outbox.phases) {
    const double begin_s = static_cast<double>(phase.begin.tick) * period_s + phase.begin.offset_s;
    if (begin_s + phase.law.duration_s() > time_s) {
      return phase.line;
    }
  }
  return std::nullopt;
}

}  // namespace

tl::expected<PlannedProgram, std::string> plan_only(ProgramFile& file, const PlanOrder& order,
                                                    Progress& progress, BlockWatch& watch) {
  // Nobody stops this plan, so nothing need leave in parts.
  Pipeline pipeline({.settings = order.settings,
                     .options = order.options,
                     .longest_phase_s = lookahead::kUnbounded,
                     .path = {.watcher = &watch, .observer = &watch}});
  const auto size = static_cast<double>(std::max<std::uint64_t>(file.size_bytes(), 1));
  std::optional<std::uint32_t> too_long_at_line;
  Pipeline::Step step = Pipeline::Step::took;
  for (lookahead::Outbox outbox; step != Pipeline::Step::ended && !too_long_at_line &&
                                 !pipeline.check().fault() && !stop_requested();
       outbox.clear()) {
    step = pipeline.step(outbox);
    if (step == Pipeline::Step::planned) {
      too_long_at_line = line_past(order.max_time_s, outbox, order.settings.limits.period_s);
    } else if (step == Pipeline::Step::wants_text) {
      const auto piece = file.read();
      if (!piece) {
        return tl::unexpected(piece.error());
      }
      if (piece->empty()) {
        pipeline.finish();
      } else {
        pipeline.feed(*piece);
      }
      progress.set_read(static_cast<double>(file.bytes_read()) / size);
    }
  }
  if (step == Pipeline::Step::ended && !pipeline.check().has_ended()) {
    pipeline.fail_without_plan(0);
  }
  return PlannedProgram{.totals = pipeline.totals(),
                        .deviation = pipeline.path().deviations().largest,
                        .path_controls = pipeline.path().path_controls(),
                        .waits = pipeline.waits_read(),
                        .errors = pipeline.path().has_errors()
                                      ? pipeline.path().diagnostics()
                                      : std::vector<diagnostics::Diagnostic>{},
                        .fault = pipeline.check().fault(),
                        .too_long_at_line = too_long_at_line};
}

}  // namespace kerf::program
