#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <variant>

#include <kerf/check.hpp>

#include "diagnostics/errors/pages.hpp"
#include "kernel/check_warnings.hpp"
#include "kernel/least_time.hpp"
#include "kernel/offset_followers.hpp"
#include "kernel/program_path.hpp"
#include "kernel/reader_options.hpp"
#include "kernel/settings_check.hpp"
#include "kernel/wait_check.hpp"
#include "kernel/work_box.hpp"
#include "machine/envelope.hpp"
#include "parser/moves/short_moves.hpp"
#include "parser/text/text.hpp"
#include "smoothing/segment_builder.hpp"

namespace kerf {
inline namespace v0 {

namespace {

void unite(curves::AuxiliaryExtents& all, const curves::AuxiliaryPosition& position, bool first) {
  for (std::size_t k = 0; k < curves::kAuxiliaryAxes; ++k) {
    all.min_rad_mm[k] = first ? position[k] : std::min(all.min_rad_mm[k], position[k]);
    all.max_rad_mm[k] = first ? position[k] : std::max(all.max_rad_mm[k], position[k]);
  }
}

// A curve of many blocks is refused where one of them proves it wrong.
diagnostics::Diagnostic refused_curve(const smoothing::PathError& error,
                                      const diagnostics::SourcePosition& begin) {
  const bool elsewhere = error.line != begin.line;
  const std::string where =
      elsewhere ? "; the curve begins in line " + std::to_string(begin.line) : "";
  return {{.line = error.line, .column = 1, .file = begin.file},
          errors::kCurveRefused,
          error.message + where};
}

class Checker {
 public:
  Checker(const MachineSettings& settings, const KernelOptions& options, const CheckBounds& bounds)
      : waits_(options),
        envelope_(machine::envelope_of(settings.table)),
        extra_envelope_(settings.table.extra),
        least_time_(settings.limits, event_time_settings(settings, options)),
        warnings_(settings.limits),
        followers_(settings, options, bounds.starts_at_first_places) {}

  void feed(std::string_view text) { followers_.feed(text); }
  void finish_text() { followers_.finish(); }

  // Of what follows an error only the curves are looked at: it may start anywhere.
  void look_at(const parser::Move& move, const ProgramPath& path, CheckReport& report) {
    segments_.clear();
    if (const auto built = smoothing::append_segments(move, segments_); !built) {
      report.diagnostics.push_back(refused_curve(built.error(), move.source));
      return;
    }
    least_time_.add(move, segments_);
    if (path.has_errors() || report.has_errors()) {
      followers_.end();
      return;
    }
    warnings_.look_at(move, report.diagnostics);
    if (waits_.refuses(move)) {
      report.diagnostics.emplace_back(move.source, errors::kNobodyAnswers, WaitCheck::kWhy);
    }
    const std::optional<Extents> box = box_of(move, report);
    followers_.look_at(move, box);
    work_.look_at(path.reader(), move, box, report);
    if (box) {
      unite(report.extra_extents, move.auxiliary.begin_rad_mm, !report.moves);
      unite(report.extra_extents, move.auxiliary.end_rad_mm, false);
      unite(report.extents, *box, !report.moves);
      report.moves = true;
    }
  }

  [[nodiscard]] const LeastTime& least_time() const noexcept { return least_time_; }
  void finish(CheckReport& report) {
    warnings_.finish(report.diagnostics);
    report.offset_extents = followers_.extents();
  }

 private:
  // That the move fills on the machine; nothing: it does not move. Complains where it leaves the
  // travel.
  std::optional<Extents> box_of(const parser::Move& move, CheckReport& report) const {
    if (segments_.empty()) {
      return std::nullopt;
    }
    check_travel(machine::outside_travel(extra_envelope_, move.auxiliary.end_rad_mm), move.source,
                 report);
    Extents box;
    for (const smoothing::PathSegment& segment : segments_) {
      const Extents extents = curves::extents(segment.curve);
      unite(box, extents, &segment == &segments_.front());
      check_travel(machine::outside_travel(envelope_, extents), move.source, report);
    }
    return box;
  }

  static void check_travel(const std::optional<machine::TravelExcess>& excess,
                           const diagnostics::SourcePosition& source, CheckReport& report) {
    const bool named = !report.limit_faults.empty() &&
                       report.limit_faults.back().source.line == source.line &&
                       report.limit_faults.back().source.file == source.file;
    if (excess && !named && report.limit_faults.size() < kMaxLimitFaults) {
      report.limit_faults.emplace_back(source, errors::kOutsideTravel, machine::describe(*excess));
    }
  }

  static constexpr std::size_t kMaxLimitFaults = 100;
  WaitCheck waits_;
  machine::Envelope envelope_;
  machine::AuxiliaryEnvelope extra_envelope_;
  LeastTime least_time_;
  CheckWarnings warnings_;
  WorkBox work_;
  OffsetFollowers followers_;
  std::vector<smoothing::PathSegment> segments_;
};

// The text alone.
class SyntaxChecker {
 public:
  SyntaxChecker(const MachineSettings& settings, const KernelOptions& options,
                const CheckBounds& /*bounds*/)
      : least_time_(settings.limits, event_time_settings(settings, options)) {}

  void feed(std::string_view /*text*/) {}
  void finish_text() {}
  void look_at(const parser::Move& move, const ProgramPath& /*path*/, CheckReport& /*report*/) {
    least_time_.add_straight(move);
  }
  [[nodiscard]] const LeastTime& least_time() const noexcept { return least_time_; }
  void finish(CheckReport& /*report*/) {}

 private:
  LeastTime least_time_;
};

void name_files(const parser::ProgramReader& reader,
                std::vector<diagnostics::Diagnostic>& diagnostics) {
  for (diagnostics::Diagnostic& diagnostic : diagnostics) {
    diagnostic.file = reader.file_name(diagnostic.source.file);
  }
}

diagnostics::Diagnostic too_long(const diagnostics::SourcePosition& source, double max_time_s) {
  return {source, errors::kTooLong,
          "up to here the program takes more than the " + parser::shortest(max_time_s) +
              " s that are allowed"};
}

diagnostics::Diagnostic too_many(const diagnostics::SourcePosition& source, std::uint64_t moves) {
  return {source, errors::kTooManyMoves,
          "up to here the program has more than the " + std::to_string(moves) +
              " moves that are allowed"};
}

// Of the text and of curves together: whether the reading ends.
class ErrorCount {
 public:
  bool is_full(const CheckReport& report, const ProgramPath& path) {
    const std::size_t found = report.diagnostics.size() + path.diagnostics().size();
    if (found != std::exchange(found_, found)) {
      errors_ = errors_in(report.diagnostics) + errors_in(path.diagnostics());
    }
    return errors_ >= static_cast<std::ptrdiff_t>(parser::ReaderOptions{}.max_errors);
  }

 private:
  static std::ptrdiff_t errors_in(const std::vector<diagnostics::Diagnostic>& list) {
    return std::count_if(list.begin(), list.end(), [](const diagnostics::Diagnostic& found) {
      return found.severity == diagnostics::Severity::error;
    });
  }

  std::size_t found_ = 0;
  std::ptrdiff_t errors_ = 0;
};

// False: what follows is never run, however long it is.
template <typename Checker>
bool feed_next(const TextSource& text, ProgramPath& path, Checker& checker) {
  const std::string_view piece = text();
  if (piece.empty()) {
    path.finish();  // its last line may not be read yet
    checker.finish_text();
  } else if (path.at_end()) {
    return false;
  } else {
    path.feed(piece);
    checker.feed(piece);
  }
  return true;
}

template <typename Checker>
CheckReport read_through(const TextSource& text, const MachineSettings& settings,
                         const KernelOptions& options, const CheckBounds& bounds) {
  CheckReport report;
  // A machine without limits is no machine to run on, but one to read a program for.
  if (auto fault = settings_fault(settings, options);
      fault && fault->page != &errors::kMachineWithoutLimit) {
    report.diagnostics.push_back(std::move(*fault));
    return report;
  }
  ProgramPath path(settings, options, {.as_programmed = true});
  Checker checker(settings, options, bounds);
  ProgramPath::Output output;
  std::uint64_t moves = 0;
  bool is_unit_known = false;
  ErrorCount errors;
  for (bool ends = false; !ends && !(bounds.stop && bounds.stop());) {
    switch (path.next(output)) {
      case ProgramPath::Next::output: {
        const auto& move = std::get<parser::Move>(output);
        if (!is_unit_known && parser::end_mm(move) != nullptr) {
          report.in_inches = path.reader().modal_state().units == parser::Units::inch;
          is_unit_known = true;
        }
        checker.look_at(move, path, report);
        if (checker.least_time().seconds() > bounds.max_time_s) {
          report.diagnostics.push_back(too_long(move.source, bounds.max_time_s));
          ends = true;
        } else if (++moves > bounds.max_moves) {
          report.diagnostics.push_back(too_many(move.source, bounds.max_moves));
          ends = true;
        } else {
          ends = errors.is_full(report, path);
        }
        break;
      }
      case ProgramPath::Next::wants_text:
        ends = !feed_next(text, path, checker);
        break;
      case ProgramPath::Next::ended:
        ends = true;
    }
  }
  checker.finish(report);
  report.nominal = checker.least_time().nominal();
  report.length_mm = checker.least_time().length_mm();
  const std::vector<diagnostics::Diagnostic>& found = path.diagnostics();
  report.diagnostics.insert(report.diagnostics.end(), found.begin(), found.end());
  name_files(path.reader(), report.diagnostics);
  name_files(path.reader(), report.limit_faults);
  std::stable_sort(report.diagnostics.begin(), report.diagnostics.end(),
                   [](const diagnostics::Diagnostic& a, const diagnostics::Diagnostic& b) {
                     return std::tie(a.source.file, a.source.line) <
                            std::tie(b.source.file, b.source.line);
                   });
  return report;
}

}  // namespace

bool CheckReport::has_errors() const {
  return std::any_of(diagnostics.begin(), diagnostics.end(), [](const diagnostics::Diagnostic& d) {
    return d.severity == diagnostics::Severity::error;
  });
}

CheckReport check_program(const TextSource& text, const MachineSettings& settings,
                          const KernelOptions& options, const CheckBounds& bounds) {
  return read_through<Checker>(text, settings, options, bounds);
}

CheckReport check_syntax(const TextSource& text, const MachineSettings& settings,
                         const KernelOptions& options, const CheckBounds& bounds) {
  return read_through<SyntaxChecker>(text, settings, options, bounds);
}

}  // namespace v0
}  // namespace kerf
