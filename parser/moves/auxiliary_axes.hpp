// The axes beside X, Y and Z that a machine file may name: A, B, C turn, U, V, W go straight.
#pragma once

#include <cstddef>
#include <string_view>

#include <kerf/axes.hpp>

#include "parser/moves/units.hpp"
#include "parser/text/letters.hpp"

namespace kerf::parser {

inline constexpr std::string_view kAuxiliaryNames = "ABCUVW";
inline constexpr Letters kAuxiliaryLetters = letters('A', 'B', 'C', 'U', 'V', 'W');

constexpr bool is_rotary(std::size_t auxiliary_axis) {
  return auxiliary_axis < 3;
}

// Anything shorter is an effect of rounding and no way (short_moves.hpp).
inline constexpr double kShortestWay_mm = 1e-10;
inline constexpr double kShortestTurn_rad = 1.7e-12;  // of A, B and C: 1e-10 degrees

// What a move does to them: A, B, C in rad, U, V, W in mm. In step with the path: linear in its
// length.
struct AuxiliaryMove {
  AuxiliaryPosition begin_rad_mm{};
  AuxiliaryPosition end_rad_mm{};

  [[nodiscard]] bool moves() const { return begin_rad_mm != end_rad_mm; }
  // Its own length, for a move on which X, Y and Z rest: along U, V, W in mm if one of them moves,
  // else along A, B, C in rad.
  [[nodiscard]] double length_rad_mm() const;
  // U, V and W rest, but for what rounding left.
  [[nodiscard]] bool only_turns() const;
};

AuxiliaryWords words_of(const AuxiliaryPosition& rad_mm);
AuxiliaryMove auxiliary_move(const AuxiliaryWords& begin_deg_mm, const AuxiliaryWords& end_deg_mm);

}  // namespace kerf::parser
