#include "programs/kerf/run/program_check.hpp"

#include <optional>
#include <string>
#include <utility>

#include "programs/kerf/io/interrupt.hpp"
#include "programs/kerf/report/fit.hpp"
#include "programs/kerf/run/block_lookup.hpp"
#include "programs/kerf/run/check_pass.hpp"
#include "programs/kerf/run/path_pass.hpp"

namespace kerf::program {

namespace {

// The program's text for the page. False: the file cannot be read.
bool keep_source(PageRecord* page, ProgramFile& file, FileReport& report) {
  if (page == nullptr || !page->wants_source || file.size_bytes() > PageRecord::kMaxSourceBytes) {
    return true;
  }
  std::string text;
  for (;;) {
    const auto piece = file.read();
    if (!piece) {
      report.fail(ExitStatus::io_error, piece.error());
      return false;
    }
    if (piece->empty()) {
      break;
    }
    text += *piece;
  }
  file.rewind();
  page->source = std::move(text);
  return true;
}

void judge(const ProgramCheck& how, const CheckReport& found, FileReport& report) {
  report.take(found.diagnostics);
  how.kernel_options.nominal = found.nominal;
  if (found.in_inches && !how.options.feed_unit) {
    report.feed_unit = FeedUnit::inch_min;
  }
  if (found.has_errors()) {
    report.status = ExitStatus::program_error;
  } else if (!found.limit_faults.empty()) {
    report.take(found.limit_faults);
    report.status = ExitStatus::machine_fault;
  }
  const auto cutting = found.cuts ? std::optional(found.cutting_extents) : std::nullopt;
  // Of a program with an error only what stands before it is known.
  const bool is_whole = found.moves && !found.has_errors();
  if (is_whole) {
    report.boxes = PathBoxes{.all = found.extents, .cutting = cutting, .work = found.work_extents};
    report.fit = fit_of(found, how.settings);
  }
  if (how.page != nullptr && is_whole) {
    how.page->extents = found.extents;
  }
  how.path = {.extents = found.moves ? std::optional(found.extents) : std::nullopt,
              .cutting = cutting,
              .extra_extents = found.extra_extents,
              .length_mm = found.length_mm};
}

// For the page: of a program that would run but for the travel, or whose path is wanted before.
void look_at_path(const ProgramCheck& how, ProgramFile& file, const FileReport& report) {
  PageRecord* page = how.page;
  if (page == nullptr || !page->extents) {
    return;
  }
  const bool is_shown = report.status == ExitStatus::done && page->show_path;
  if (is_shown || report.status == ExitStatus::machine_fault) {
    file.rewind();
    path_pass({.settings = how.settings,
               .options = how.kernel_options,
               .feed_override = how.options.feed_override},
              file, *page);
  }
  if (is_shown) {
    page->show_path(report);
  }
}

}  // namespace

bool check_program(const ProgramCheck& how, ProgramFile& file, FileReport& report) {
  if (!keep_source(how.page, file, report)) {
    return false;
  }
  KernelOptions kernel_options = how.kernel_options;
  if (how.options.from_line || how.options.continues) {
    kernel_options.refuses_waits = false;  // those after the start are looked for once it is known
  }
  const auto found = check_pass(
      file, how.settings, kernel_options,
      {.max_time_s = how.options.max_time_s,
       .max_moves = how.options.max_moves,
       .shows_progress = how.shows_progress,
       .syntax_only = how.options.syntax_only,
       .starts_at_first_places = std::holds_alternative<AtFirstMove>(how.options.start)});
  if (stop_requested()) {
    report.status = *stop_requested();
  } else if (!found) {
    report.fail(ExitStatus::io_error, found.error());
  } else {
    judge(how, *found, report);
    fill_in_blocks(report.diagnostics, file);
    look_at_path(how, file, report);
  }
  return report.status == ExitStatus::done;
}

}  // namespace kerf::program
