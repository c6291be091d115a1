// G38.2 to G38.5: straight moves that end where the tool touches the simulated table's surface, or
// leaves it.
#pragma once

#include <optional>

#include "parser/modal/end_point.hpp"
#include "parser/modal/touch_box.hpp"

namespace kerf::parser {

struct ProbeWay {
  Point end_mm{};
  double length_mm = 0.0;
};
// Where the probe ends if it meets nothing. Nothing: the block does not probe.
Expected<std::optional<ProbeWay>> read_probe(const RunningBlock& at, const ModalState& state);

struct ProbeMove {
  Point end_mm{};
  double feedrate_mm_s = 0.0;
};
// No box: there is nothing to touch.
Done run_probe(const RunningBlock& at, ModalState& state, const std::optional<TouchBox>& box,
               const ProbeMove& asked);

}  // namespace kerf::parser
