#include "programs/plan_only.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/blend_settings.hpp"
#include "kernel/reader_options.hpp"
#include "lookahead/block_builder.hpp"
#include "lookahead/planner.hpp"
#include "lookahead/push.hpp"
#include "parser/program_reader.hpp"
#include "programs/interrupt.hpp"
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

}  // namespace

tl::expected<PlannedProgram, std::string> plan_only(ProgramFile& file,
                                                    const MachineSettings& settings,
                                                    const KernelOptions& options,
                                                    Progress& progress, BlockWatch& watch) {
  parser::ReaderOptions reading = reader_options(settings, options);
  reading.watched_line = watch.line();
  parser::ProgramReader reader(std::move(reading));
  smoothing::Smoother smoother(blend_settings(settings));
  lookahead::Planner planner({.limits = settings.limits,
                              .profile = options.profile,
                              .window_blocks = options.window_blocks});
  const auto size = static_cast<double>(std::max<std::uint64_t>(file.size_bytes(), 1));
  lookahead::Outbox outbox;
  smoothing::Smoother::Output output;
  bool program_ended = false;
  bool finished = false;
  PlanCheck check;
  for (parser::Move move; !stop_requested() && !check.fault();) {
    outbox.clear();
    if (planner.emit(outbox)) {
      check.emitted(outbox);
      watch.planned(outbox);
    } else if (finished) {
      break;
    } else if (smoother.next(output)) {
      push(output, settings.limits, planner, check, watch);
    } else if (program_ended) {
      check.judge(smoother.departure());
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
  return PlannedProgram{
      .totals = planner.totals(), .departure = smoother.departure(), .fault = check.fault()};
}

}  // namespace kerf::program
