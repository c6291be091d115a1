// The G and M codes: which modal group each is in and whether this parser knows it.
#pragma once

#include <array>
#include <cstdint>

#include "diagnostics/fault.hpp"
#include "parser/block/block.hpp"
#include "parser/dialects/dialect_rules.hpp"
#include "parser/modal/modal_state.hpp"

namespace kerf::parser {

// The modal groups of RS274/NGC [NISTIR 6556, table 4], as far as they hold a code that runs here.
enum class Group : std::uint8_t {
  other,  // for one block: G4, G10, G28, G28.1, G30, G30.1, G52, G53, G92
  motion,
  cycle,  // G80; with Fanuc the cycles too, before they join the motion
  plane,
  distance,
  arc_distance,
  feed_mode,
  units,
  cutter_compensation,
  length_offset,
  work_offset,
  path,
  retract,       // G98, G99
  spindle_mode,  // G96, G97
  local_offset,  // G92.1, G92.2, G92.3
  scaling,       // Fanuc: G50, G51
  mirror,        // Fanuc: G50.1, G51.1
  program_turn,  // Fanuc: G68, G69
  stop,          // from here on M codes
  tool,
  spindle,
  coolant,
  in_out,     // M62 to M68
  overrides,  // M48 to M53
  state,      // M70 to M73
  count
};

// A code as ten times its number: G5.2 is 52, M3 is 30.
using Tenths = std::int16_t;
inline constexpr Tenths kNoCode = -1;

// Of G17, G18 or G19 (else), and of G93, G95 or G94 (else).
constexpr Plane plane_of(Tenths code) {
  return code == 170 ? Plane::xy : code == 180 ? Plane::zx : Plane::yz;
}
constexpr FeedMode feed_mode_of(Tenths code) {
  return code == 930   ? FeedMode::inverse_time
         : code == 950 ? FeedMode::per_revolution
                       : FeedMode::per_minute;
}

struct BlockCodes {
  struct Entry {
    Tenths tenths = kNoCode;
    std::uint8_t index = 0;  // in BlockWords::g or BlockWords::m
  };
  std::array<Entry, static_cast<std::size_t>(Group::count)> by_group;
  bool filled = false;  // an entry may hold a code; most blocks have none and need no clearing

  [[nodiscard]] Tenths operator[](Group group) const {
    return by_group[static_cast<std::size_t>(group)].tenths;
  }
  [[nodiscard]] bool has(Group group) const { return (*this)[group] != kNoCode; }
};

// For sort_codes, which keeps blocks without codes away from it.
diagnostics::Done sort_some_codes(const BlockWords& block, const DialectRules& rules,
                                  BlockCodes& codes);

// Sorts the block's codes into their groups. The fault is of the leftmost wrong code: not known,
// not supported, or a second one of its group.
inline diagnostics::Done sort_codes(const BlockWords& block, const DialectRules& rules,
                                    BlockCodes& codes) {
  if (block.g_count + block.m_count == 0 && !codes.filled) {
    return {};
  }
  return sort_some_codes(block, rules, codes);
}

// The word that put a code into `group`. Precondition: codes.has(group).
const Word& code_word(const BlockWords& block, const BlockCodes& codes, Group group);

}  // namespace kerf::parser
