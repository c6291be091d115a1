// What a program begins with, and what it leaves.
#include "parser/reader/program_run.hpp"

namespace kerf::parser {

namespace {

ModalState state_at_start(const MachineData& machine, Dialect dialect) {
  ModalState state;
  state.to_initial_level = rules_of(dialect).starts_at_initial;
  state.path_mode = machine.path_control.mode;
  state.blend_tolerance_mm = machine.path_control.corner_tolerance_mm;
  state.merge_tolerance_mm = machine.path_control.merge_tolerance_mm;
  for (std::size_t system = 0; system < Coordinates::kSystems; ++system) {
    state.coordinates.set_work(system, machine.work[system]);
  }
  return state;
}

// As M2 and M30 of LinuxCNC: F, the units, G43, G92 and the path mode stay.
void end_program(ModalState& state) {
  state.coordinates.select(0);
  state.plane = Plane::xy;
  state.incremental = false;
  state.feed_mode = FeedMode::per_minute;
  state.overrides = {};
  state.spindle = Spindle::off;
  state.motion = Motion::line;
  state.cycle = {};
  state.mist = state.flood = false;
}

}  // namespace

ProgramMemory ProgramRun::memory_of(const ReaderOptions& options) {
  const ReaderState* const before = options.begins_with.get();
  ProgramMemory memory;
  memory.answers = options.answers;
  memory.dialect = options.dialect;
  memory.machine = before != nullptr ? before->machine : options.machine;
  memory.state =
      before != nullptr ? before->modal : state_at_start(options.machine, options.dialect);
  memory.state.position_mm = options.start_mm;
  memory.state.auxiliary_deg_mm = words_of(options.start_extra_rad_mm);
  return memory;
}

// Calls that are open end, and with them their locals; so does a compensated contour.
ReaderState ProgramRun::state_left(const std::optional<ModalState>& modal) const {
  ReaderState left{.modal = modal.value_or(interpreter_.state()),
                   .machine = interpreter_.memory().machine,
                   .parameters = parameters_};
  while (left.parameters.depth() > 0) {
    left.parameters.pop_frame();
  }
  left.modal.cutter_compensation = ModalState{}.cutter_compensation;
  if (!modal && interpreter_.program_ended()) {
    end_program(left.modal);
  }
  return left;
}

}  // namespace kerf::parser
