// What a program takes from the machine that it runs on.
#pragma once

#include <array>
#include <optional>

#include "parser/modal/coordinates.hpp"
#include "parser/modal/tool_table.hpp"
#include "parser/modal/touch_box.hpp"
#include "parser/moves/move.hpp"

namespace kerf::parser {

struct HomePosition {
  Point mm{};  // in machine coordinates
  ExtraWords extra_deg_mm{};
};

struct MachineData {
  std::array<WorkOffset, Coordinates::kSystems> work{};  // G54 to G59.3
  Point first_home_mm{};                                 // G28, in machine coordinates
  Point second_home_mm{};                                // G30
  Letters extra_axes = 0;  // those of A, B, C, U, V, W that the machine has
  ExtraWords first_home_extra_deg_mm{};
  ExtraWords second_home_extra_deg_mm{};
  std::array<HomePosition, 2> further_homes{};  // Fanuc: G30 P3, P4
  ToolTable tools;
  std::optional<TouchBox> touch_box{};  // what G38 finds
  // What a number without a decimal point counts in, in the Fanuc dialect; 0: millimetres.
  double least_increment_mm = 0.0;
  // What G64 without P and without both takes for P and for Q; not negative.
  double corner_tolerance_mm = 0.01;
  double merge_tolerance_mm = 0.01;
};

// Of the default machine: no offsets, and a tool changer with 60 places. T1 (10 mm, 12.5 mm long),
// T2 (6 mm) and T3 (20 mm, -3 mm) are measured, the others have length and diameter 0. A probe
// touches the table's top at Z-150.
MachineData default_machine_data();

}  // namespace kerf::parser
