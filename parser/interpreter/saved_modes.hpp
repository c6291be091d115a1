// What M70 saves and M72 brings back.
#pragma once

#include "parser/modal/modal_state.hpp"

namespace kerf::parser {

// The modes of LinuxCNC's M70: G17 to G19, G20, G21, G90, G91, G90.1, G91.1, G93 to G95, G96, G97,
// G54 to G59.3, whether G43 and G92 are in force, G61 to G64, F, S, spindle, coolant, overrides.
// Neither the motion mode nor where offsets lie: those that the program has moved meanwhile stay
// moved.
struct SavedModes {
  ModalState state;
  bool restore_at_return = false;  // M73
};

// Takes the saved modes over into `state`, but for the tool offset. Spindle and coolant are what
// they are to be: the caller tells the machine.
void restore_modes(const SavedModes& saved, ModalState& state);

}  // namespace kerf::parser
