#include "kernel/program_path.hpp"

#include <utility>

#include "kernel/blend_settings.hpp"
#include "kernel/reader_options.hpp"
#include "parser/errors/machine.hpp"
#include "parser/short_moves.hpp"

namespace kerf {

ProgramPath::ProgramPath(const MachineSettings& settings, const KernelOptions& options)
    : reader_(reader_options(settings, options)),
      smoother_(blend_settings(settings)),
      end_{.position_mm = options.start_mm, .extra_rad_mm = options.start_extra_rad_mm} {
  if (options.checks_travel) {
    travel_.emplace(settings);
  }
}

ProgramPath::Next ProgramPath::next(Output& output) {
  for (;;) {
    if (smoother_.next(output)) {
      if (!cut_) {
        return Next::output;
      }
    } else if (ended_) {
      return Next::ended;
    } else if (!read_move()) {
      return Next::wants_text;
    }
  }
}

bool ProgramPath::read_move() {
  parser::Move move;
  const bool read = reader_.next(move);
  if (!read && !reader_.has_errors() && !reader_.at_end()) {
    return false;
  }
  if (!read || reader_.has_errors()) {
    end();
    return true;
  }
  source_ = move.source;
  if (const auto* end = parser::end_mm(move)) {
    end_ = {.position_mm = *end, .extra_rad_mm = move.extra.end_rad_mm};
  }
  // Before smoothing, which may round the corner into the move or merge it with others.
  if (const auto excess = travel_ ? travel_->excess_of(move) : std::nullopt) {
    left_travel_ = true;
    fail({source_.line, machine::describe(*excess)}, parser::errors::kOutsideTravel);
    return true;
  }
  if (const auto taken = smoother_.push(move); !taken) {
    fail(taken.error(), parser::errors::kCurveRefused);
  }
  return true;
}

std::optional<PlaceOfTool> ProgramPath::programmed_end() const {
  return has_errors() ? std::nullopt : std::optional(end_);
}

void ProgramPath::cut(const parser::SourcePosition& source, const smoothing::PathError& error,
                      const parser::ErrorPage& page) {
  cut_ = true;
  source_ = source;
  fail(error, page);
}

void ProgramPath::refuse(parser::Diagnostic fault) {
  cut_ = true;
  failed_ = true;
  source_ = fault.source;
  all_diagnostics_ = {std::move(fault)};
  end();
}

void ProgramPath::fail(const smoothing::PathError& error, const parser::ErrorPage& page) {
  failed_ = true;
  all_diagnostics_ = reader_.diagnostics();
  parser::SourcePosition place = source_;
  if (error.line != place.line) {  // inside a curve of many blocks
    place.line = error.line;
    place.column = 1;
  }
  parser::Diagnostic& diagnostic = all_diagnostics_.emplace_back(place, page, error.message);
  diagnostic.file = reader_.file_name(place.file);
  end();
}

void ProgramPath::end() {
  smoother_.flush();
  ended_ = true;
}

}  // namespace kerf
