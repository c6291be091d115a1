#include "programs/kerf/run/first_scan.hpp"

#include <variant>
#include <vector>

#include "kernel/reader_options.hpp"
#include "lookahead/path/block_builder.hpp"
#include "lookahead/planner.hpp"
#include "parser/program_reader.hpp"
#include "programs/kerf/io/interrupt.hpp"

namespace kerf::program {

namespace {

std::optional<ScannedCurve> scan_of(const parser::Move& move, const MachineSettings& settings,
                                    const KernelOptions& options) {
  const lookahead::Planner planner(
      {.limits = settings.limits, .profile = profiles::Profile(options.profile)});
  std::vector<lookahead::Block> blocks;
  if (!lookahead::append_blocks(move, settings.limits, blocks, planner.scan_for()) ||
      blocks.empty() || blocks.front().limit_curve.size() < 2) {
    return std::nullopt;
  }
  return ScannedCurve(blocks.front().line, std::move(blocks.front().limit_curve));
}

}  // namespace

std::optional<ScannedCurve> first_scan(ProgramFile& file, const MachineSettings& settings,
                                       const KernelOptions& options) {
  parser::ProgramReader reader(reader_options(settings, options));
  for (bool over = false; !over && !stop_requested();) {
    const auto piece = file.read();
    over = !piece || piece->empty();
    if (over) {
      reader.finish();
    } else {
      reader.feed(*piece);
    }
    for (parser::Move move; reader.next(move);) {
      if (std::holds_alternative<parser::NurbsMove>(move.shape)) {
        return scan_of(move, settings, options);
      }
    }
  }
  return std::nullopt;
}

}  // namespace kerf::program
