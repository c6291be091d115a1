#include "programs/kerf/run/path_pass.hpp"

#include <utility>
#include <variant>

#include "kernel/program_path.hpp"
#include "kernel/reader_options.hpp"
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

void path_pass(const PathOrder& order, ProgramFile& file, PageRecord& page) {
  const auto& [settings, options, feed_override] = order;
  PlannedPath& planned = page.planned.emplace(page.extents.value_or(curves::Extents{}));
  NominalLines nominal({.limits = settings.limits,
                        .events = event_time_settings(settings, options),
                        .feed_override = feed_override});
  ProgramPath path(without_travel(settings), options, {});
  // A file that cannot be read any more ends the path there.
  static_cast<void>(walk_path(file, path, [&](const ProgramPath::Output& output) {
    std::visit([&nominal](const auto& part) { nominal.add(part); }, output);
    if (const auto* segment = std::get_if<smoothing::PathSegment>(&output)) {
      planned.add(*segment);
    }
    return true;
  }));
  if (page.show_path) {
    page.nominal = std::move(nominal);
  }
}

}  // namespace kerf::program
