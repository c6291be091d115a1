#include "programs/kerf/run/path_pass.hpp"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

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

std::vector<std::string> files_of(const PlannedPath& planned, const parser::ProgramReader& reader) {
  std::uint16_t last = 0;
  for (const PlannedPath::Part& part : planned.parts()) {
    last = std::max(last, part.file);
  }
  std::vector<std::string> files;
  for (std::uint16_t file = 1; file <= last; ++file) {
    files.emplace_back(reader.file_name(file));
  }
  return files;
}

}  // namespace

void path_pass(ProgramFile& file, const PathPassOrder& order, PageRecord& page) {
  PlannedPath& planned = page.planned.emplace(page.extents.value_or(curves::Extents{}));
  ProgramPath path(order.leaves_travel ? without_travel(order.settings) : order.settings,
                   order.kernel_options, {});
  for (ProgramPath::Output output; !stop_requested();) {
    switch (path.next(output)) {
      case ProgramPath::Next::output:
        if (const auto* segment = std::get_if<smoothing::PathSegment>(&output)) {
          planned.add(*segment);
        } else {
          planned.add_pause(std::get<parser::Move>(output).source);
        }
        break;
      case ProgramPath::Next::ended:
        page.files = files_of(planned, path.reader());
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
