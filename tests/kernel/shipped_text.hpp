// Programs for the kernel's tests.
#pragma once

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include <kerf/kernel.hpp>

#include "lookahead/path/limits.hpp"

namespace kerf::test {

inline std::string shipped_program(const std::string& name) {
  std::ifstream file(std::string(KERF_SOURCE_DIR) + "/programs/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Lines, arcs in two planes, a helix, a corner, a dwell, an exact stop and a curve.
inline std::string mixed_program() {
  return "G21 G90 G17 G94\n"
         "G1 X30 F3600\n"
         "G3 X30 Y20 J10\n"
         "G1 X0\n"
         "G1 Y19\n"
         "G4 P0.0503\n"
         "G2 X0 Y19 Z3 J6 F2400\n"
         "G61.1 G1 X5 F3000\n"
         "G61 G18 G3 X15 I5 F1800\n"
         "G17 G1 X20 Y19.5 Z3 F3000\n"
         "G6.2 P4 K0 X20 Y19.5 Z3 F4000\n"
         "K0 X30 Y40 R2\n"
         "K0 X50 Y40 Z5 R2\n"
         "K0 X60 Y20\n"
         "K1\nK1\nK1\nK1\n"
         "G0 X0 Y0 Z0\n"
         "M30\n";
}

inline MachineSettings mill() {
  MachineSettings settings;
  const lookahead::MotionLimits axis{
      .velocity_mm_s = 200.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 5e4};
  settings.limits.axes = {axis, axis, axis};
  settings.limits.path = {.velocity_mm_s = 150.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 5e4};
  settings.limits.chord_tolerance_mm = 5e-4;
  return settings;
}

// On the mill, at the most: 20 ms until a request has changed the motion, A/J until it accelerates
// no more, and an S-curve from the largest feedrate, v/A + A/J. A program that ends sooner may end
// before it is held.
inline constexpr std::int64_t kLongestStop_ticks = 20 + 40 + 75 + 40;

}  // namespace kerf::test
