#include "programs/kerf/run/path_pass.hpp"

#include <variant>

#include "kernel/program_path.hpp"
#include "programs/kerf/run/path_walk.hpp"

namespace kerf::program {

namespace {

MachineSettings without_travel(MachineSettings settings) {
  for (AxisDrive& axis : settings.table.axes) {
    axis.travel = {};
  }
  settings.table.extra = {};
  return settings;
}

}  // namespace

void path_pass(ProgramFile& file, const MachineSettings& settings, const KernelOptions& options,
               PageRecord& page) {
  PlannedPath& planned = page.planned.emplace(page.extents.value_or(curves::Extents{}));
  ProgramPath path(without_travel(settings), options, {});
  // A file that cannot be read any more ends the path there.
  static_cast<void>(walk_path(file, path, [&planned](const ProgramPath::Output& output) {
    if (const auto* segment = std::get_if<smoothing::PathSegment>(&output)) {
      planned.add(*segment);
    }
    return true;
  }));
}

}  // namespace kerf::program
