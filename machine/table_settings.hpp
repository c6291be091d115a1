// The simulated table's data, one struct for each axis.
#pragma once

#include <array>
#include <limits>

#include "curves/auxiliary_axis_motion.hpp"

namespace kerf::machine {

struct Travel {
  double min_mm = -std::numeric_limits<double>::infinity();
  double max_mm = std::numeric_limits<double>::infinity();
};

// Of A, B, C in rad, of U, V, W in mm.
struct AuxiliaryTravel {
  double min_rad_mm = -std::numeric_limits<double>::infinity();
  double max_rad_mm = std::numeric_limits<double>::infinity();
};

// Forces and gains are divided by the moved inertia, so that no mass appears: a torque is the
// acceleration that it would give, in mm/s2 at the table.
//
// The defaults are those of the default table. Screw and encoder are those of the servo table in
// Huang and Zhu's paper on sine-series feedrate profiles; the gains and friction make the contour
// error on the butterfly in the paper's 4.8 s what was measured there, 20.9 um at the most and
// 3.9 um in the mean: 20 and 3.3 um.
struct AxisDrive {
  Travel travel{};
  double drive_velocity_mm_s = 500.0;      // what the motor can do; saturates the velocity command
  double drive_acceleration_mm_s2 = 20e3;  // the motor's largest torque
  double screw_lead_mm = 10.0;             // table travel per motor revolution
  double counts_per_rev = 10'000.0;        // encoder resolution; infinity: no quantisation
  double position_gain_per_s = 120.0;      // Kv of the outer loop
  double velocity_gain_per_s = 1000.0;     // proportional gain of the inner loop
  double velocity_integral_per_s2 = 50e3;  // integral gain of the inner loop
  double feed_forward = 1.0;               // share of the commanded velocity fed forward, 0..1
  double coulomb_friction_mm_s2 = 500.0;   // opposes motion, and holds at rest up to this force
  double viscous_friction_per_s = 5.0;
  double max_following_error_mm = 5.0;
};

struct TableSettings {
  double period_s = 0.001;
  std::array<AxisDrive, 3> axes{};
  std::array<AuxiliaryTravel, curves::kAuxiliaryAxes>
      extra{};  // without drives: see SimulatedTable
};

// Every number is of its kind (gains, lead, counts and drive limits positive, friction and integral
// not negative, feed_forward in 0..1, min < max, period in 1e-5..0.1 s) and finite where the struct
// does not say otherwise.
[[nodiscard]] bool is_valid(const TableSettings& settings) noexcept;

}  // namespace kerf::machine
