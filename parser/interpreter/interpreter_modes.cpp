// The codes beside the motion, in their order.
#include "parser/compensation/compensation_codes.hpp"
#include "parser/dialects/fanuc/fanuc_codes.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/interpreter/modes.hpp"
#include "parser/offsets/program_data.hpp"
#include "parser/offsets/reference_points.hpp"
#include "parser/offsets/work_offsets.hpp"
#include "parser/spindle_io/switches.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG4 = 40;
constexpr Tenths kG10 = 100;
constexpr Tenths kG28 = 280;
constexpr Tenths kStoreG28 = 281;
constexpr Tenths kG30 = 300;
constexpr Tenths kStoreG30 = 301;
constexpr Tenths kG52 = 520;
constexpr Tenths kG92 = 920;

}  // namespace

// What F needs to know.
void Interpreter::set_units_and_feed_mode(const BlockCodes& codes) {
  if (codes.has(Group::units)) {
    set_units(memory_.state, codes[Group::units] == 200 ? Units::inch : Units::mm);
  }
  if (codes.has(Group::feed_mode)) {
    feed_.set_mode(memory_.state, feed_mode_of(codes[Group::feed_mode]));
  }
}

// The M codes in the order of RS274/NGC.
Done Interpreter::switch_machine(const RunningBlock& at) {
  ModalState& state = memory_.state;
  return switch_in_out(at, state, memory_.answers)
      .and_then([&] { return change_tool(at, state, memory_.machine.tools); })
      .and_then([&] { return spindle_.start(at, state, memory_.answers); })
      .and_then([&] { return save_modes(at); })
      .and_then([&] {
        switch_coolant(at, state);
        return switch_overrides(at, state);
      });
}

// M70 to M73. By now a spindle that M3 or M4 starts runs.
Done Interpreter::save_modes(const RunningBlock& at) {
  const Tenths spindle = at.codes[Group::spindle];
  if (spindle == 30 || spindle == 40) {
    feed_.spindle_started();
  }
  if (!at.codes.has(Group::state)) {
    return {};
  }
  Expected<std::optional<ModalState>> saved = saved_modes_.run(at, memory_.state);
  if (!saved) {
    return fault_of(saved);
  }
  if (*saved) {
    bring_back(at, **saved);
  }
  return {};
}

// G4 comes before the modes.
Done Interpreter::set_modes(const RunningBlock& at) {
  ModalState& state = memory_.state;
  const BlockCodes& codes = at.codes;
  if (codes[Group::other] == kG4) {
    if (Done done = dwell(at, state); !done) {
      return done;
    }
  }
  if (codes.has(Group::plane)) {
    state.plane = plane_of(codes[Group::plane]);
  }
  if (codes.has(Group::cutter_compensation)) {
    if (Done done = set_compensation(at); !done) {
      return done;
    }
  }
  if (codes.has(Group::distance)) {
    state.incremental = codes[Group::distance] == 910;
  }
  if (codes.has(Group::arc_distance)) {
    state.absolute_centre = codes[Group::arc_distance] == 901;
  }
  if (codes.has(Group::retract)) {
    state.to_initial_level = codes[Group::retract] == 980;
  }
  if (codes.has(Group::motion)) {
    set_motion(at, state, codes[Group::motion]);
  }
  if (Done done = set_coordinates(at); !done) {
    return done;
  }
  return set_path_mode(at, state, memory_.machine);
}

Done Interpreter::set_compensation(const RunningBlock& at) {
  ModalState& state = memory_.state;
  if (at.codes[Group::cutter_compensation] == kG40) {
    if (compensation_.on()) {
      compensation_.stop();
    }
    state.cutter_compensation = kG40;
    return {};
  }
  Expected<CompensationStart> start =
      read_compensation(at, state, memory_.machine.tools, compensation_.on());
  if (!start) {
    return fault_of(start);
  }
  compensation_.start(*start);
  tell_contour_faults();
  return {};
}

Done Interpreter::set_coordinates(const RunningBlock& at) {
  ModalState& state = memory_.state;
  if (at.codes.has(Group::length_offset)) {
    if (Done done = set_length_offset(at, state, memory_.machine.tools); !done) {
      return done;
    }
  }
  if (at.codes[Group::work_offset] == 541) {
    if (Done done = select_extended_offset(at, state); !done) {
      return done;
    }
  }
  select_work_offset(at.codes, state.coordinates);
  change_local_offset(at.codes, state);
  return at.rules.control_codes ? shape_program(at, state) : Done();
}

// The codes that do something once, in place of the block's motion.
Done Interpreter::do_once(const RunningBlock& at) {
  ModalState& state = memory_.state;
  MachineData& machine = memory_.machine;
  switch (at.codes[Group::other]) {
    case kG10:
      return set_data(at);
    case kG28:
    case kG30:
      return go_to_reference_point(at);
    case kStoreG28:
      machine.first_home_mm = state.position_mm;
      machine.first_home_extra_deg_mm = state.auxiliary_deg_mm;
      return {};
    case kStoreG30:
      machine.second_home_mm = state.position_mm;
      machine.second_home_extra_deg_mm = state.auxiliary_deg_mm;
      return {};
    case kG52:
    case kG92:
      return set_local_offset(at, state);
    default:
      return {};
  }
}

Done Interpreter::set_data(const RunningBlock& at) {
  ToolTable& tools = memory_.machine.tools;
  return at.rules.offset_memory ? set_fanuc_data(at, memory_.state, tools)
                                : parser::set_data(at, memory_.state, tools);
}

Done Interpreter::go_to_reference_point(const RunningBlock& at) {
  const MachineData& machine = memory_.machine;
  Expected<HomePosition> home =
      at.codes[Group::other] == kG30
          ? second_reference_point(at.block, machine)
          : HomePosition{machine.first_home_mm, machine.first_home_extra_deg_mm};
  if (!home) {
    return fault_of(home);
  }
  return go_home(at, memory_.state, *home, compensation_.phase());
}

}  // namespace kerf::parser
