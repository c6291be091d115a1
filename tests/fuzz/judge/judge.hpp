// What must hold for any bytes. Where something does not, the process ends.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "parser/moves/move.hpp"
#include "tests/fuzz/judge/fuzz_input.hpp"

namespace kerf::fuzz {

// Where the tool is after the last move.
struct EndPoint {
  parser::Point mm{};
  std::array<double, kAuxiliaryAxes> extra_rad_mm{};
};

// The parser does not crash, ends, says where an error is, and hands on only moves that a curve
// builder can work with. Nothing where the program has errors or more moves than are looked at.
std::optional<EndPoint> judge_reading(const FuzzInput& input);

// The program is checked, planned and run: every tick is finite and no faster than the machine, the
// last is `end`, and the run ends, at the latest once it is stopped. What the check passes, runs.
void judge_motion(const FuzzInput& input, const EndPoint& end);

// Both.
void judge(std::span<const std::uint8_t> bytes);

}  // namespace kerf::fuzz
