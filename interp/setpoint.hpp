// What a machine is told at one tick.
#pragma once

#include <cstdint>

#include "curves/auxiliary_axis_motion.hpp"
#include "curves/position.hpp"
#include "interp/constraint.hpp"
#include "interp/outputs.hpp"

namespace kerf::interp {

using curves::Position;

struct Setpoint {
  std::int64_t tick = 0;                // counts interpolation periods from 0
  std::uint32_t line = 0;               // of the block that the point belongs to
  bool rapid = false;                   // on a G0
  Constraint limit = Constraint::rest;  // what limits the feedrate from here to the next tick
  double s_mm = 0.0;                    // path length since the program's start, of X, Y and Z
  double v_mm_s = 0.0;                  // along the path, as planned; 0 where only extra axes move
  double a_mm_s2 = 0.0;
  double j_mm_s3 = 0.0;
  Position position_mm{};
  Position velocity_mm_s{};
  Position acceleration_mm_s2{};
  curves::AuxiliaryPosition extra_rad_mm{};  // A, B, C, U, V, W; at rest if the machine has none
  Outputs outputs{};
};

}  // namespace kerf::interp
