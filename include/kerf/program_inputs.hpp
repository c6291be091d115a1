// What a machine answers to a program: G38, M66 and the spindle.
#pragma once

#include <array>
#include <cstdint>

#include <kerf/api.hpp>
#include <kerf/axes.hpp>
#include <kerf/setpoint.hpp>

namespace kerf {
inline namespace v0 {

/// As of the setpoint before.
struct ProgramInputs {
  bool probe = false;  ///< it touches
  /// Where X, Y and Z are, in machine coordinates: at the tick in which the probe's input is as G38
  /// looks for it, the program gets this place.
  Position actual_mm{};
  /// The drive knows where they were as the probe's input changed within the last tick: then the
  /// program gets that.
  bool has_latched = false;
  Position latched_mm{};
  std::uint64_t digital = 0;                      ///< M66 P: bit n is input n
  std::array<double, Outputs::kAnalog> analog{};  ///< M66 E
  bool spindle_at_speed = true;                   ///< what ProgramData::waits_for_spindle waits for
};

}  // namespace v0
}  // namespace kerf
