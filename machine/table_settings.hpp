// The simulated table's data, one struct for each axis.
#pragma once

#include <array>
#include <limits>

namespace kerf::machine {

struct Travel {
  double min_mm = -std::numeric_limits<double>::infinity();
  double max_mm = std::numeric_limits<double>::infinity();
};

struct AxisDrive {
  Travel travel{};
  double max_velocity_mm_s = 500.0;       // what the motor can do
  double max_acceleration_mm_s2 = 10e3;   // saturates the motor's torque
  double screw_lead_mm = 10.0;
  double counts_per_rev = 10'000.0;
  double position_gain_per_s = 150.0;     // Kv of the outer loop
  double velocity_gain_per_s = 1500.0;    // proportional gain of the inner loop, by inertia
  double velocity_integral_per_s2 = 0.0;  // integral gain of the inner loop, by inertia
  double feed_forward = 1.0;              // share of the commanded velocity fed forward, 0..1
  double coulomb_friction_mm_s2 = 0.0;    // friction force by inertia
  double viscous_friction_per_s = 0.0;
  double max_following_error_mm = 5.0;
};

struct TableSettings {
  double period_s = 0.001;
  std::array<AxisDrive, 3> axes{};
};

}  // namespace kerf::machine
