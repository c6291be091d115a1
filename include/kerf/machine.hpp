// A machine: its limits, what programs take from it, the simulated table, and the file that
// describes them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <kerf/api.hpp>
#include <kerf/axes.hpp>
#include <kerf/program_data.hpp>
#include <kerf/simulation.hpp>
#include <tl/expected.hpp>

namespace kerf {
inline namespace v0 {

/// Of X, Y or Z, in machine coordinates.
struct Travel {
  double min_mm = -kUnbounded;
  double max_mm = kUnbounded;
};

/// Of A, B, C in rad, of U, V, W in mm.
struct AuxiliaryTravel {
  double min_rad_mm = -kUnbounded;
  double max_rad_mm = kUnbounded;
};

/// The drive of the simulated table; the plan uses none of it but travel. Forces and gains are
/// divided by the moved inertia, so that no mass appears: a torque is the acceleration that it
/// would give, in mm/s2 at the table. Defaults: a servo axis with a ball screw.
struct AxisDrive {
  Travel travel{};
  double drive_velocity_mm_s = 500.0;  ///< what the motor can do; saturates the velocity command
  double drive_acceleration_mm_s2 = 20e3;  ///< the motor's largest torque
  double screw_lead_mm = 10.0;             ///< table travel per motor revolution
  double counts_per_rev = 10'000.0;        ///< encoder resolution; infinity: no quantisation
  double position_gain_per_s = 120.0;      ///< Kv of the outer loop
  double velocity_gain_per_s = 1000.0;     ///< proportional gain of the inner loop
  double velocity_integral_per_s2 = 50e3;  ///< integral gain of the inner loop
  double feed_forward = 1.0;               ///< share of the commanded velocity fed forward, 0..1
  double coulomb_friction_mm_s2 = 500.0;   ///< opposes motion, and holds at rest up to this force
  double viscous_friction_per_s = 5.0;
  double max_following_error_mm = 5.0;
};

/// The simulated table.
struct TableSettings {
  double period_s = 0.001;  ///< of the simulated table alone; the plan uses MachineLimits::period_s
  std::array<AxisDrive, 3> axes{};
  std::array<AuxiliaryTravel, kAuxiliaryAxes> extra{};  ///< they follow without drives
};

/// How X, Y or Z finds its place. All moves of it are jerk-limited.
struct AxisHoming {
  double switch_mm = kUnbounded;  ///< where the home switch closes; kUnbounded: there is none
  double home_mm = kUnbounded;    ///< where the axis goes at the end; kUnbounded: to the switch
  double search_mm_s = -10.0;     ///< towards the switch: the sign is the direction; not 0
  double latch_mm_s = 1.0;        ///< the second time, which counts; > 0
  double back_off_mm = 10.0;      ///< by then the switch has opened again, or it is stuck
  /// By then it is closed, or there is none. kUnbounded: from the farther end of the travel to the
  /// switch and back_off_mm, of an axis without travel 2000.
  double travel_mm = kUnbounded;
  double time_s = 120.0;  ///< each move of the search takes at most so long
  double order = 1.0;     ///< the lowest one is first; of the same one X before Y before Z
};

/// What an operator may do by hand.
struct ManualSettings {
  double jog_mm_s = kUnbounded;   ///< no jog is faster, along its path; of A, B, C alone deg/s
  double unhomed_jog_mm_s = 0.0;  ///< the same while not homed, without travel; 0: none then
  double jog_timeout_s = 0.5;     ///< a continuous jog that is not renewed ends
  bool runs_unhomed = false;      ///< programs and lines run though a home switch was not found
  std::array<AxisHoming, 3> homing{};
};

/// The limits of the motion, the data that programs use, and the simulated table. A machine of your
/// own needs the first two; of the table only the travel counts then.
struct MachineSettings {
  MachineLimits limits{};
  ProgramData program{};
  TableSettings table{};
  SimulationSettings simulation{};   ///< around the table; also what a check assumes of probes
  Dialect dialect = Dialect::rs274;  ///< of its programs, unless told otherwise
  ManualSettings manual{};
  /// The tool table that the file names but does not hold; empty: none. The library opens no files:
  /// read it yourself, give its text to read_tool_table() and put the result into program.tools.
  std::string tool_file{};
  /// The same of the height map that a probe touches: read_height_map(), simulation.surface.
  std::string height_map_file{};
};

/// What is wrong with settings or options.
struct SettingsError {
  unsigned line = 0;  ///< of a machine file, 1-based; 0 where no place is to blame
  unsigned column = 0;
  std::string message;
};

/// "file:line:column: error: message", or "file: error: message" where no place is to blame.
KERF_API std::string to_string(const SettingsError& error, std::string_view file);

/// The schema is in docs/machine-file.md. What the text leaves out keeps the defaults of the
/// structs, the limits of a plan then do not bind. All errors are returned, in the order of the
/// text (of a text that is not TOML only the first, and nothing else).
//
/// Errors: not TOML, unknown key, wrong type, impossible value, a limit that nothing bounds (each
/// of velocity, acceleration and jerk needs a value along the path or on all three axes), min_mm
/// not below max_mm, a drive weaker than the axis' limits, a position loop faster than the velocity
/// loop, over 1 MiB.
KERF_API tl::expected<MachineSettings, std::vector<SettingsError>> parse_machine_file(
    std::string_view toml);

/// The default table: what programs/machines/table.toml says, without a file.
KERF_API MachineSettings default_machine();

/// The first impossible value, under the name that the machine file has for it where it has one:
/// "axes.x.max_mm".
/// MachineLimits says which limits must be bounded. Each number of the table's drives is checked by
/// itself; whether the drives can follow the plan is not.
KERF_API tl::expected<void, SettingsError> validate(const MachineSettings& settings);

}  // namespace v0
}  // namespace kerf
