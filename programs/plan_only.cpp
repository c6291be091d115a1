#include "programs/plan_only.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/reader_options.hpp"
#include "lookahead/block_builder.hpp"
#include "lookahead/planner.hpp"
#include "lookahead/switches.hpp"
#include "parser/program_reader.hpp"
#include "programs/interrupt.hpp"

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

// Into the planner's window. True: as a rest.
bool push(lookahead::Planner& planner, const parser::Move& move,
          const lookahead::PlanLimits& limits, std::vector<lookahead::Block>& blocks) {
  if (const auto* dwell = std::get_if<parser::DwellMove>(&move.shape)) {
    planner.push_rest(dwell->duration_s, move.source.line);
    return true;
  }
  if (const auto* event = std::get_if<parser::EventMove>(&move.shape)) {
    lookahead::push_event(*event, move.source.line, planner);
    return !lookahead::is_at_motion(event->kind);
  }
  blocks.clear();
  if (lookahead::append_blocks(move, limits, blocks)) {
    for (lookahead::Block& block : blocks) {
      planner.push(std::move(block));
    }
  }
  return false;
}

}  // namespace

tl::expected<lookahead::PlanTotals, std::string> plan_only(ProgramFile& file,
                                                           const MachineSettings& settings,
                                                           const KernelOptions& options,
                                                           Progress& progress, BlockWatch& watch) {
  parser::ReaderOptions reading = reader_options(settings, options);
  reading.watched_line = watch.line();
  parser::ProgramReader reader(std::move(reading));
  lookahead::Planner planner({.limits = settings.limits,
                              .profile = options.profile,
                              .window_blocks = options.window_blocks});
  const auto size = static_cast<double>(std::max<std::uint64_t>(file.size_bytes(), 1));
  lookahead::Outbox outbox;
  std::vector<lookahead::Block> blocks;
  bool finished = false;
  for (parser::Move move; !stop_requested();) {
    outbox.clear();
    if (planner.emit(outbox)) {
      watch.planned(outbox);
      continue;
    }
    if (finished) {
      break;
    }
    const auto found = next_move(reader, file, move);
    if (!found) {
      return tl::unexpected(found.error());
    }
    watch.read(reader);
    if (*found) {
      watch.moves(move);
      if (push(planner, move, settings.limits, blocks)) {
        watch.rests();
      }
    } else {
      planner.finish(move.source.line);
      finished = true;
    }
    progress.set_read(static_cast<double>(file.bytes_read()) / size);
  }
  return planner.totals();
}

}  // namespace kerf::program
