// G38.2 to G38.5: straight moves that end where the tool touches something, or leaves it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "parser/modal/end_point.hpp"
#include "parser/modal/machine_source.hpp"

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
// The moves of a probe. Where the machine is asked, what it answers is for take_probe_answer().
Done run_probe(const RunningBlock& at, ModalState& state, const MachineSource& machine,
               const ProbeMove& asked);

// For the errors of a probe: which it is, where in its line, and what a message ends with.
struct AskedProbe {
  Motion motion = Motion::none;
  std::uint32_t offset = 0;
  std::string_view why{};
};
Done take_probe_answer(const AskedProbe& asked, const MachineAnswer& answer, ModalState& state);

}  // namespace kerf::parser
