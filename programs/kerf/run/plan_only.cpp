#include "programs/kerf/run/plan_only.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/blend_settings.hpp"
#include "kernel/reader_options.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/planner.hpp"
#include "lookahead/push.hpp"
#include "parser/program_reader.hpp"
#include "programs/kerf/io/interrupt.hpp"
#include "smoothing/smoother.hpp"

namespace kerf::program {

namespace {

// The next move, with text from the file as it takes. Nothing at the end.
tl::expected<bool, std::string> next_move(parser::ProgramReader& reader, ProgramFile& file,
                                          parser::Move& move) {
  while (!reader.next(move)) {
    if (reader.at_end()) {
      return false;
    }
    const auto piece = file.read();
    if (!piece) {
      return tl::unexpected(piece.error());
    }
    if (piece->empty()) {
      reader.finish();
    } else {
      reader.feed(*piece);
    }
  }
  return true;
}

// What is next of the path, or a pause on it, into the planner's window.
void push(smoothing::Smoother::Output& output, const lookahead::PlanLimits& limits,
          lookahead::Planner& planner, PlanCheck& check, BlockWatch& watch) {
  if (const auto* pause = std::get_if<parser::Move>(&output)) {
    lookahead::push_pause(*pause, planner);
    watch.rests();
    return;
  }
  auto& part = std::get<smoothing::PathPart>(output);
  const std::vector<parser::EventMove> changes = std::move(part.changes);
  if (auto block = lookahead::block_of(std::move(part), limits, planner.scan_for())) {
    check.pushed(*block);
    lookahead::push_block(std::move(*block), changes, planner);
  }
}

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
  const lookahead::PlanLimits& limits = order.settings.limits;
  parser::ReaderOptions reading = reader_options(order.settings, order.options);
  reading.watched_line = watch.line();
  parser::ProgramReader reader(std::move(reading));
  smoothing::Smoother smoother(blend_settings(order.settings));
  // Nobody stops this plan, so a cruise need not leave in parts.
  lookahead::Planner planner({.limits = limits,
                              .profile = order.options.profile,
                              .window_blocks = order.options.window_blocks,
                              .longest_cruise_s = lookahead::kUnbounded});
  const auto size = static_cast<double>(std::max<std::uint64_t>(file.size_bytes(), 1));
  lookahead::Outbox outbox;
  smoothing::Smoother::Output output;
  bool program_ended = false;
  bool finished = false;
  PlanCheck check;
  std::optional<std::uint32_t> too_long_at_line;
  for (parser::Move move; !too_long_at_line && !check.fault() && !stop_requested();) {
    outbox.clear();
    if (planner.emit(outbox)) {
      check.emitted(outbox);
      watch.planned(outbox);
      too_long_at_line = line_past(order.max_time_s, outbox, limits.period_s);
    } else if (finished) {
      break;
    } else if (smoother.next(output)) {
      push(output, limits, planner, check, watch);
    } else if (program_ended) {
      check.judge(smoother.departures().worst);
      planner.finish(move.source.line);
      finished = true;
    } else {
      const auto found = next_move(reader, file, move);
      if (!found) {
        return tl::unexpected(found.error());
      }
      watch.read(reader);
      if (*found) {
        watch.moves(move);
        smoother.push(move);
      } else {
        smoother.flush();
        program_ended = true;
      }
      progress.set_read(static_cast<double>(file.bytes_read()) / size);
    }
  }
  if (finished && !check.has_ended()) {
    check.fail(0, "the program is read and nothing is planned");
  }
  return PlannedProgram{.totals = planner.totals(),
                        .departure = smoother.departures().largest,
                        .fault = check.fault(),
                        .too_long_at_line = too_long_at_line};
}

}  // namespace kerf::program
