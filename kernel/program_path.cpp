#include "kernel/program_path.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "diagnostics/errors/pages.hpp"
#include "kernel/reader_options.hpp"
#include "kernel/tick_judge.hpp"
#include "machine/envelope.hpp"
#include "parser/moves/short_moves.hpp"

namespace kerf {

namespace {

// The weakest axis' limits, and the table's travel.
smoothing::BlendSettings blend_settings(const MachineSettings& settings) {
  const lookahead::PlanLimits& limits = settings.limits;
  smoothing::BlendSettings blend{.acceleration_mm_s2 = limits.path.acceleration_mm_s2,
                                 .jerk_mm_s3 = limits.path.jerk_mm_s3};
  const machine::Envelope envelope = machine::envelope_of(settings.table);
  curves::Extents travel;
  for (std::size_t k = 0; k < 3; ++k) {
    blend.acceleration_mm_s2 =
        std::min(blend.acceleration_mm_s2, limits.axes[k].acceleration_mm_s2);
    blend.jerk_mm_s3 = std::min(blend.jerk_mm_s3, limits.axes[k].jerk_mm_s3);
    travel.min_mm[k] = envelope[k].min_mm;
    travel.max_mm[k] = envelope[k].max_mm;
  }
  blend.travel = travel;
  return blend;
}

parser::ReaderOptions options_for(const ProgramPath::Order& order, const MachineSettings& settings,
                                  const KernelOptions& options) {
  parser::ReaderOptions reader = reader_options(settings, options);
  reader.watcher = order.watcher;
  reader.answers.is_asked = order.asks_machine;
  if (options.start_in_program) {
    reader.answers.asked_from_block = options.start_in_program->blocks_before + 1;
  }
  return reader;
}

bool asks(const ProgramPath::Output& output) {
  const auto* move = std::get_if<parser::Move>(&output);
  const auto* event = move != nullptr ? std::get_if<parser::EventMove>(&move->shape) : nullptr;
  return event != nullptr && event->kind == parser::EventKind::ask_machine;
}

}  // namespace

ProgramPath::ProgramPath(const MachineSettings& settings, const KernelOptions& options,
                         const Order& order)
    : order_(order),
      reader_(options_for(order, settings, options)),
      travel_(settings),
      checks_travel_(options.checks_travel),
      waits_(options),
      smoother_(blend_settings(settings)),
      end_{.position_mm = options.start_mm, .extra_rad_mm = options.start_extra_rad_mm} {
  if (options.start_in_program && !order.as_programmed) {
    start_.emplace(*options.start_in_program, settings,
                   options_for(order, settings, options).answers, end_);
  }
  smoother_.keep_exact_lines_apart(order.keeps_exact_lines_apart || start_);
}

ProgramPath::Next ProgramPath::next(Output& output) {
  if (order_.as_programmed) {
    return next_as_programmed(output);
  }
  for (;;) {
    if (next_to_run(output)) {
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

bool ProgramPath::next_to_run(Output& output) {
  while (way_to_start_.empty()) {
    if (!smoother_.next(output)) {
      return false;
    }
    if (!start_) {
      return true;
    }
    if (!start_->leaves_out(output)) {
      for (Output& part : start_->way_to(output)) {
        way_asks_ |= asks(part);
        way_to_start_.push_back(std::move(part));
      }
      way_to_start_.push_back(std::move(output));
      start_.reset();
      smoother_.keep_exact_lines_apart(order_.keeps_exact_lines_apart);
    }
  }
  output = std::move(way_to_start_.front());
  way_to_start_.pop_front();
  return true;
}

ProgramPath::Next ProgramPath::next_as_programmed(Output& output) {
  if (reader_.next(output.emplace<parser::Move>())) {
    return Next::output;
  }
  return has_all_text_ ? Next::ended : Next::wants_text;
}

void ProgramPath::note_path_control(const parser::Move& move) {
  if (move.probes || move.in_cycle) {
    return;
  }
  const PathControlUse use{.control = {.mode = move.mode,
                                       .corner_tolerance_mm = move.blend_tolerance_mm,
                                       .merge_tolerance_mm = move.merge_tolerance_mm},
                           .by_program = move.mode_by_program};
  const bool is_last = !path_controls_.empty() && path_controls_.back() == use;
  if (!is_last && path_controls_.size() < kPathControls &&
      std::ranges::find(path_controls_, use) == path_controls_.end()) {
    path_controls_.push_back(use);
  }
}

bool ProgramPath::read_move() {
  parser::Move move;
  const bool read = reader_.next(move);
  if (order_.observer != nullptr) {
    order_.observer->read(reader_);
  }
  if (!read && (reader_.question() || (!reader_.has_errors() && !reader_.at_end()))) {
    return false;
  }
  if (!read || reader_.has_errors()) {
    end();
    return true;
  }
  if (order_.observer != nullptr) {
    order_.observer->move(move);
  }
  source_ = move.source;
  if (const auto* end = parser::end_mm(move)) {
    end_ = {.position_mm = *end, .extra_rad_mm = move.auxiliary.end_rad_mm};
    note_path_control(move);
  }
  if (!(start_ && start_->leaves_out(move.block)) && refuses(move)) {
    return true;
  }
  if (const auto taken = smoother_.push(move); !taken) {
    fail(taken.error(), errors::kCurveRefused);
  }
  return true;
}

// Before smoothing, which may round the corner into the move or merge it with others.
bool ProgramPath::refuses(const parser::Move& move) {
  if (const auto excess = checks_travel_ ? travel_.excess_of(move) : std::nullopt) {
    left_travel_ = true;
    fail({source_.line, machine::describe(*excess)}, errors::kOutsideTravel);
    return true;
  }
  if (waits_.refuses(move)) {
    fail({source_.line, WaitCheck::kWhy}, errors::kNobodyAnswers);
    return true;
  }
  return false;
}

void ProgramPath::answer(const parser::MachineAnswer& answer) {
  if (std::exchange(way_asks_, false)) {
    return;  // the reader knows nothing of it, and may have a question of its own by now
  }
  if (parser::is_probe(*reader_.question())) {
    end_.position_mm = answer.rest_mm;
  }
  reader_.answer(answer);
}

std::optional<PlaceOfTool> ProgramPath::programmed_end() const {
  return has_errors() || start_ ? std::nullopt : std::optional(end_);
}

void ProgramPath::cut(const diagnostics::SourcePosition& source, const smoothing::PathError& error,
                      const diagnostics::ErrorPage& page) {
  cut_ = true;
  source_ = source;
  fail(error, page);
}

void ProgramPath::refuse(diagnostics::Diagnostic fault) {
  cut_ = true;
  failed_ = true;
  source_ = fault.source;
  all_diagnostics_ = {std::move(fault)};
  end();
}

void ProgramPath::fail(const smoothing::PathError& error, const diagnostics::ErrorPage& page) {
  failed_ = true;
  all_diagnostics_ = reader_.diagnostics();
  diagnostics::SourcePosition place = source_;
  if (error.line != place.line) {  // inside a curve of many blocks
    place.line = error.line;
    place.column = 1;
  }
  diagnostics::Diagnostic& diagnostic = all_diagnostics_.emplace_back(place, page, error.message);
  diagnostic.file = reader_.file_name(place.file);
  end();
}

void ProgramPath::end() {
  smoother_.flush();
  ended_ = true;
}

}  // namespace kerf
