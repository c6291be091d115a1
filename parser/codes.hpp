// The G and M codes: which modal group each is in and whether this parser knows it.
#pragma once

#include <array>
#include <cstdint>

#include "parser/block.hpp"
#include "parser/fault.hpp"

namespace kerf::parser {

// The modal groups of RS274/NGC (NISTIR 6556, table 4), as far as they hold a code that runs here.
enum class Group : std::uint8_t {
  other,  // G4, G53: for one block
  motion,
  cycle_cancel,  // G80: beside another motion code, that one counts
  plane,
  distance,
  arc_distance,
  feed_mode,
  units,
  cutter_compensation,
  length_offset,
  work_offset,
  path,
  stop,
  tool,
  spindle,
  coolant,
  count
};

// A code as ten times its number: G5.2 is 52, M3 is 30.
using Tenths = std::int16_t;
inline constexpr Tenths kNoCode = -1;

struct BlockCodes {
  struct Entry {
    Tenths tenths = kNoCode;
    std::uint8_t index = 0;  // in Block::g or Block::m
  };
  std::array<Entry, static_cast<std::size_t>(Group::count)> by_group;

  [[nodiscard]] Tenths operator[](Group group) const {
    return by_group[static_cast<std::size_t>(group)].tenths;
  }
  [[nodiscard]] bool has(Group group) const { return (*this)[group] != kNoCode; }
};

// Sorts the block's codes into their groups. False, with the fault of the leftmost wrong code:
// not known, not supported yet, or a second one of its group.
bool sort_codes(const Block& block, BlockCodes& codes, Fault& fault);

// The word that put a code into `group`. Precondition: codes.has(group).
const Word& code_word(const Block& block, const BlockCodes& codes, Group group);

}  // namespace kerf::parser
