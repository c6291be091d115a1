// The reader's options and those of what events take, made in one place: the check, the plan and
// the run must read the same program.
#pragma once

#include <memory>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "kernel/program_state.hpp"
#include "kernel/simulated_answers.hpp"
#include "lookahead/event_time.hpp"
#include "parser/flow/reader_options.hpp"

namespace kerf {

// The time in which what follows an answer of the machine is planned: the motion goes on after it,
// however long the planning took within it, so that every run has the same ticks.
inline constexpr double kPauseBehindAnswer_s = 0.05;
// At rest the machine is asked a tick later, and what it says is there at the next one.
inline constexpr double kTicksOfAnswer = 2.0;

// The drives may have been off meanwhile, and with them spindle and coolant.
inline std::shared_ptr<const parser::ReaderState> state_at_start(const KernelOptions& options) {
  if (options.begins_with.content() == nullptr) {
    return nullptr;
  }
  parser::ReaderState state = options.begins_with.content()->of_reader;
  const Outputs& outputs = options.start_outputs;
  if (outputs.spindle_rad_s == 0.0 && state.modal.spindle_speed != 0.0) {
    state.modal.spindle = parser::Spindle::off;
  }
  state.modal.mist = outputs.mist;
  state.modal.flood = outputs.flood;
  state.modal.loaded_tool = outputs.tool;
  state.modal.outputs = {.digital = outputs.digital, .analog = outputs.analog};
  return std::make_shared<const parser::ReaderState>(std::move(state));
}

inline parser::ReaderOptions reader_options(const MachineSettings& settings,
                                            const KernelOptions& options) {
  return {.start_mm = options.start_mm,
          .start_extra_rad_mm = options.start_extra_rad_mm,
          .block_delete = options.block_delete,
          .dialect = options.dialect.value_or(settings.dialect),
          .answers = {.waits_for_spindle = settings.program.waits_for_spindle,
                      .assumed = std::make_shared<const SimulatedAnswers>(settings,
                                                                          options.assumes_contact),
                      .answer_s = kPauseBehindAnswer_s + kTicksOfAnswer * settings.limits.period_s,
                      .look_s = settings.limits.period_s,
                      .spindle_start_s = settings.program.spindle_start_s},
          .machine = settings.program,
          .begins_with = state_at_start(options),
          .one_line = options.one_line,
          .subprograms = options.subprograms,
          .keeps_messages = options.tells_operator};
}

inline lookahead::EventTime::Settings event_time_settings(const MachineSettings& settings,
                                                          const KernelOptions& options) {
  return {.tool_change_s = settings.program.tool_change_s,
          .spindle_start_s = settings.program.spindle_start_s,
          .spindle_turns = options.start_outputs.spindle_rad_s != 0.0};
}

}  // namespace kerf
