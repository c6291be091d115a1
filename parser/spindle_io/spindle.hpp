// The spindle: S, G96, G97, M3, M4, M5, M19.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "parser/modal/machine_source.hpp"
#include "parser/modal/running_block.hpp"

namespace kerf::parser {

// S, G96 and G97; with Fanuc S beside G92 is the highest speed of G96.
Done set_speed(const RunningBlock& at, ModalState& state);
// Revolutions per minute. With G96 those that give the surface speed S at the place where the tool
// is now.
double spindle_per_min(const ModalState& state);

// Clockwise positive: of spindle_cw and spindle_ccw.
inline double turns_per_min(const EventMove& event) {
  return event.kind == EventKind::spindle_cw ? event.value : -event.value;
}

// Clockwise positive.
struct SpeedChange {
  double from_per_min = 0.0;
  double to_per_min = 0.0;
};

// What waits, in that block, until the spindle turns as it was told: a question to the machine, or
// as long as an assumed one takes. Nothing: nothing waits.
using SpindleWait = std::variant<EventMove, DwellMove>;
std::optional<SpindleWait> wait_for_speed(const MachineSource& machine, std::uint64_t block,
                                          const SpeedChange& change);

// What the machine was told last.
class SpindleDrive {
 public:
  // M3, M4, M5, M19; a new S while the spindle turns is sent as its direction once more.
  Done start(const RunningBlock& at, ModalState& state, const MachineSource& machine);
  // Tells a turning spindle when an offset or the unit has changed what X0 or S is to it.
  void follow_moved_axis(const MoveSink& at, const ModalState& state);
  // The event that turns the spindle at the speed that S and G96 give at this place.
  EventMove turn(const ModalState& state, Spindle direction);
  // The same as the state has it, and the wait for it.
  void turn_on(const MoveSink& at, const ModalState& state, const MachineSource& machine);
  void turn_off(const MoveSink& at, const ModalState& state);

 private:
  SurfaceFollowing followed_{};
  double turns_per_min_ = 0.0;  // clockwise positive
};

}  // namespace kerf::parser
