// M70 to M73: modes saved and brought back.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "parser/modal/running_block.hpp"

namespace kerf::parser {

// The modes of LinuxCNC's M70: G17 to G19, G20, G21, G90, G91, G90.1, G91.1, G93 to G95, G96, G97,
// G54 to G59.3, whether G43 and G92 are in force, G61 to G64, F, S, spindle, coolant, overrides.
// The motion mode and the offsets' values are not saved: an offset that the program has changed
// since stays changed.
class SavedModes {
 public:
  // M70 to M73; what M72 brings back.
  Expected<std::optional<ModalState>> run(const RunningBlock& at, const ModalState& state);
  void enter_subprogram();
  // What M73 brings back.
  std::optional<ModalState> leave_subprogram();
  [[nodiscard]] std::size_t open_calls() const { return calls_.size() - 1; }

  // Takes the saved modes over into `state`. Spindle and coolant are what they are to be: the
  // caller tells the machine.
  static void bring_back(const ModalState& saved, const ToolTable& tools, ModalState& state);

 private:
  struct Entry {
    ModalState state;
    bool restore_at_return = false;  // M73
  };
  std::vector<std::optional<Entry>> calls_{1};  // of the main program and of each call that is open
};

}  // namespace kerf::parser
