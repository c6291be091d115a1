#include "programs/kerf/run/path_pass.hpp"

#include <variant>

#include "kernel/program_path.hpp"
#include "programs/kerf/io/interrupt.hpp"

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
  for (ProgramPath::Output output; !stop_requested();) {
    switch (path.next(output)) {
      case ProgramPath::Next::output:
        if (const auto* segment = std::get_if<smoothing::PathSegment>(&output)) {
          planned.add(*segment);
        }
        break;
      case ProgramPath::Next::ended:
        return;
      case ProgramPath::Next::wants_text:
        if (const auto piece = file.read(); piece && !piece->empty()) {
          path.feed(*piece);
        } else {
          path.finish();
        }
        break;
    }
  }
}

}  // namespace kerf::program
