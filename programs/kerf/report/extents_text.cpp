#include "programs/kerf/report/extents_text.hpp"

#include <cmath>
#include <iterator>
#include <string_view>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/number_text.hpp"
#include "programs/kerf/io/visible_text.hpp"
#include "programs/kerf/report/extra_axes.hpp"

namespace kerf::program {

namespace {

std::string box_text(const curves::Extents& box) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    text += fmt::format("{}{} {} to {}", k == 0 ? "" : ", ", "xyz"[k],
                        fixed_number(box.min_mm[k], 3), fixed_number(box.max_mm[k], 3));
  }
  return text + " mm";
}

std::string systems_text(const WorkExtents& work) {
  std::string text;
  for (const std::size_t system : work.systems) {
    text += (text.empty() ? "" : ", ") + work_system_name(system);
  }
  return text;
}

std::string extra_axes_text(const FileReport& report) {
  std::string text;
  const curves::AuxiliaryExtents& extra = report.plan->extra_extents;
  for (const ExtraAxis& axis : extra_axes(report.extra_axes)) {
    text += fmt::format(", {} {} to {} {}", axis.name,
                        fixed_number(axis.factor * extra.min_rad_mm[axis.index], 3),
                        fixed_number(axis.factor * extra.max_rad_mm[axis.index], 3), axis.unit);
  }
  return text;
}

struct Row {
  std::string_view name{};
  std::string_view motion{};
  std::string machine;  // boxes
  std::string program;
  std::string more;  // of the machine
};

// One for the machine's coordinates and one for the program's, or one for both where they are the
// same.
std::string row_text(const Row& row, const WorkExtents& work) {
  std::string text =
      fmt::format("  {:<15} {}{}   {}on the machine", row.name, row.machine, row.more, row.motion);
  const bool is_same = work.is_known && row.machine == row.program;
  if (work.is_known) {
    text += is_same ? " and in " : fmt::format("\n{:18}{}   {}in ", "", row.program, row.motion);
    text += systems_text(work);
  }
  return text + '\n';
}

}  // namespace

std::string extents_text(const FileReport& report) {
  return box_text(report.plan->extents) + extra_axes_text(report);
}

std::string extents_rows(const FileReport& report) {
  if (!report.boxes || report.start || report.status != ExitStatus::done) {
    return fmt::format("  extents         {}\n", extents_text(report));
  }
  const PathBoxes& boxes = *report.boxes;
  std::string text = row_text({.name = "extents",
                               .motion = "all motion, ",
                               .machine = box_text(boxes.all),
                               .program = box_text(boxes.work.all),
                               .more = extra_axes_text(report)},
                              boxes.work);
  if (boxes.cutting) {
    text += row_text({.name = "cutting",
                      .machine = box_text(*boxes.cutting),
                      .program = box_text(boxes.work.cutting),
                      .more = {}},
                     boxes.work);
  }
  return text;
}

namespace {

// One of them is finite: the path goes beyond it.
std::string travel_text(const Travel& travel) {
  const std::string min = short_number(travel.min_mm);
  const std::string max = short_number(travel.max_mm);
  return !std::isfinite(travel.min_mm)   ? "up to " + max
         : !std::isfinite(travel.max_mm) ? "from " + min
                                         : min + " to " + max;
}

}  // namespace

std::string misfit_text(const FileReport& report) {
  if (!report.fit || report.fit->fits() || report.status != ExitStatus::machine_fault) {
    return {};
  }
  std::string text = visible(report.file) + ": does not fit\n";
  const curves::Extents& box = report.boxes->all;
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisFit& axis = report.fit->axes[k];
    if (axis.over_mm > 0.0) {
      fmt::format_to(std::back_inserter(text),
                     "  {}               {} to {} mm, over by {} mm; travel {} mm\n", "xyz"[k],
                     fixed_number(box.min_mm[k], 3), fixed_number(box.max_mm[k], 3),
                     fixed_number(axis.over_mm, 3), travel_text(axis.travel));
    }
  }
  if (report.fit->extra_excess) {
    fmt::format_to(std::back_inserter(text), "  other axes      {}\n", *report.fit->extra_excess);
  }
  const auto* label = report.fit->extra_excess ? "x, y, z fit with " : "would fit       ";
  for (const std::string& line : describe(*report.fit)) {
    fmt::format_to(std::back_inserter(text), "  {}{}\n", label, line);
  }
  return text;
}

}  // namespace kerf::program
