// The words of a canned cycle, which hold until it ends.
#pragma once

#include <array>
#include <optional>

namespace kerf::parser {

// In mm and seconds, as the program gave them: with G91 they are distances. LinuxCNC reads what
// holds from before in the mode of the block that uses it, Fanuc in that of the block that gave it.
struct CycleWords {
  std::optional<double> clearance_mm;  // R
  std::optional<double> bottom_mm;     // Z, or the word of the drilling axis
  bool clearance_adds = false;         // given with G91
  bool bottom_adds = false;
  std::optional<double> peck_mm;                   // Q
  std::optional<double> dwell_s;                   // P
  std::array<std::optional<double>, 3> offset_mm;  // I, J, K of G87
};

// What lasts from one cycle to the next.
struct CycleState {
  CycleWords words;
  bool in_series = false;   // the block before was of a cycle too
  double initial_mm = 0.0;  // where the tool was before the series, in the program's coordinates
};

}  // namespace kerf::parser
