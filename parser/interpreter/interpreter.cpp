#include "parser/interpreter/interpreter.hpp"

#include <algorithm>
#include <cmath>

#include "parser/block/lexical_error.hpp"
#include "parser/cycles/drill_cycle.hpp"
#include "parser/dialects/fanuc/least_increment.hpp"
#include "parser/modal/word_users.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG80 = 800;

}  // namespace

Interpreter::Interpreter(const Point& start_mm, diagnostics::DiagnosticList& diagnostics,
                         MachineData machine, Dialect dialect, const ExtraWords& start_extra_deg_mm)
    : InterpreterMemory(diagnostics, std::move(machine), dialect) {
  state_.position_mm = start_mm;
  state_.extra_deg_mm = start_extra_deg_mm;
  state_.to_initial_level = dialect == Dialect::fanuc;
  for (std::size_t system = 0; system < Coordinates::kSystems; ++system) {
    state_.coordinates.set_work(system, machine_.work[system]);
  }
}

bool Interpreter::fail(std::uint32_t offset, const diagnostics::ErrorPage& page,
                       std::string message) {
  fault_ = {offset, std::move(message), &page};
  return false;
}

void Interpreter::report(const diagnostics::Fault& fault) {
  compensation_.forget_faults();
  if (reported_line_ != line_) {
    diagnostics_->add_at(fault.elsewhere.value_or(diagnostics_->place({line_, fault.offset + 1})),
                         *fault.page, fault.message);
    reported_line_ = line_;
  }
}

void Interpreter::warn(std::uint32_t offset, const diagnostics::ErrorPage& page,
                       std::string message) {
  diagnostics_->add({line_, offset + 1}, page, std::move(message));
}

Move& Interpreter::push_move() {
  Move& move = moves_.push();
  move.source = {line_, block_->first_word + 1, file_};
  move.block = blocks_run_;
  move.start_mm = state_.position_mm;
  move.rapid = false;
  move.feedrate_mm_s = 0.0;
  carry_extra(move, state_.extra_deg_mm);
  move.mode = state_.path_mode;
  move.blend_tolerance_mm = state_.blend_tolerance_mm;
  move.merge_tolerance_mm = state_.merge_tolerance_mm;
  return move;
}

void Interpreter::run(const Block& block, std::uint32_t line, bool complete) {
  block_ = &block;
  ++blocks_run_;
  if (dialect_ == Dialect::fanuc && machine_.least_increment_mm != 0.0) {
    counted_block_ = block;
    count_in_least_increments(state_, machine_.least_increment_mm, counted_block_);
    block_ = &counted_block_;
  }
  line_ = line;
  const bool sorted = sort_codes(block, dialect_, codes_, fault_);
  if (skipped_curve_ != kNoCode) {
    if (!sorted || !complete || !leave_skipped_curve()) {
      recover();
      return;
    }
  }
  if (!complete && (sorted || block.stop == Stop::too_many_g)) {
    fault_ = explain_stop(block);
  }
  if (!(sorted && complete && execute())) {
    report(fault_);
    if (curve_open()) {
      abandon_curve();
    } else {
      skip_curve_of_wrong_block();
    }
    recover();
  }
  if (compensation_.busy()) {
    compensate_moves();
  }
}

void Interpreter::end(std::uint32_t last_line, std::string_view where) {
  line_ = last_line;
  if (curve_open()) {
    report(of_curve(nurbs_.active() ? nurbs_.unfinished(0, where) : uniform_.unfinished(0, where)));
    abandon_curve();
  }
  if (compensation_.busy()) {
    compensation_.finish({last_line, 1, file_});
    compensate_moves();
  }
}

void Interpreter::end_program(diagnostics::SourcePosition source) {
  source.file = file_;
  Move& move = moves_.push();
  move = Move{EventMove{EventKind::program_end, 0.0}, source, state_.position_mm};
  move.block = blocks_run_;
  carry_extra(move, state_.extra_deg_mm);
  program_ended_ = true;
}

// In the order that the class names. Part of execute(), a call for each block would be felt.
[[gnu::always_inline]] inline bool Interpreter::do_words() {
  if (block_->g_count > 0) {
    set_units_and_feed_mode();
  }
  if ((block_->has_any(letters('F', 'S', 'T')) || codes_.has(Group::spindle_mode)) &&
      !(set_feed() && set_speed() && select_tool())) {
    return false;
  }
  if ((block_->m_count > 0 || block_->has('S')) && !switch_machine()) {
    return false;
  }
  if (block_->g_count > 0 && !set_modes()) {
    return false;
  }
  if (state_.surface_speed.active) {
    follow_moved_axis();
  }
  if (!move()) {
    return false;
  }
  if (block_->m_count > 0) {
    stop();
  }
  return true;
}

bool Interpreter::execute() {
  if (dialect_ == Dialect::fanuc && codes_.has(Group::motion)) {
    settle_cycle_group();
  }
  if (compensation_.on() && !allowed_while_compensating()) {
    return false;
  }
  if (curve_open()) {
    if (!reports_open_curve()) {
      return continue_curve();
    }
    abandon_curve();
    skipped_curve_ = kNoCode;
  }
  if (begins_curve()) {
    return begin_curve();
  }
  return check_words() && do_words();
}

// Takes over what can be told of a block with an error; see the class.
void Interpreter::recover() {
  const Block& block = *block_;
  for (std::size_t i = 0; i < block.g_count; ++i) {
    recover_code(block.g[i].value);
  }
  const CurveBlock here = curve_block();
  Point end;
  ExtraWords extra_end;
  diagnostics::Fault ignored;
  if (block.has_any(axis_letters()) && !is_cycle(state_.motion) &&
      taker_of_axes(block, codes_) == Group::count &&
      resolve_point(here, state_.position_mm, end, ignored) && resolve_extra(extra_end)) {
    state_.position_mm = end;
    state_.extra_deg_mm = extra_end;
  }
  if (block.has('F') && block.value('F') > 0.0 && state_.feed_mode == FeedMode::per_minute) {
    state_.feed_word = block.value('F');
    state_.feedrate_mm_s = feedrate_mm_s_from(state_.feed_word, state_.units);
  }
}

void Interpreter::recover_code(double g) {
  const double tenths = std::round(std::clamp(g, 0.0, 99.0) * 10.0);
  const auto code = static_cast<Tenths>(tenths);
  if (std::fabs(g * 10.0 - tenths) > 1e-8) {
    return;
  }
  switch (code) {
    case 170:
    case 180:
    case 190:
      state_.plane = plane_of(code);
      break;
    case 200:
    case 210:
      set_units(code == 200 ? Units::inch : Units::mm);
      break;
    case 900:
    case 910:
      state_.incremental = code == 910;
      break;
    case 930:
    case 940:
    case 950:
      set_feed_mode(feed_mode_of(code));
      break;
    default:
      recover_motion(code);
      break;
  }
}

void Interpreter::recover_motion(Tenths code) {
  const bool plain = code == 0 || code == 10 || code == 20 || code == 30;
  const bool ends_cycle = code == kG80 && codes_[Group::motion] == kG80;
  if (plain || ends_cycle || is_cycle(static_cast<Motion>(code))) {
    set_motion(code);
  } else if (code >= 540 && code <= 593 && codes_[Group::work_offset] == code) {
    select_work_offset();
  } else if (code == 400 && compensation_.on()) {
    compensation_.stop();
  }
}

}  // namespace kerf::parser
