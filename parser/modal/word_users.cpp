#include "parser/modal/word_users.hpp"

#include <array>

namespace kerf::parser {

namespace {

struct Use {
  Group group;
  Tenths code;
  Letters letters;
};

constexpr std::array kUses{
    Use{Group::other, 40, letters('P')},
    Use{Group::other, 100, letters('P', 'L', 'R', 'I', 'J', 'Q')},
    Use{Group::work_offset, 541, letters('P')},
    Use{Group::scaling, 510, letters('P', 'I', 'J', 'K')},
    Use{Group::program_turn, 680, letters('R')},
    Use{Group::path, 640, letters('P', 'Q')},
    Use{Group::cutter_compensation, 410, letters('D')},
    Use{Group::cutter_compensation, 411, letters('D', 'L')},
    Use{Group::cutter_compensation, 420, letters('D')},
    Use{Group::cutter_compensation, 421, letters('D', 'L')},
    Use{Group::length_offset, 430, letters('H')},
    Use{Group::length_offset, 432, letters('H')},
    Use{Group::length_offset, 440, letters('H')},
    Use{Group::spindle_mode, 960, letters('D')},
    Use{Group::tool, 610, letters('Q')},
    Use{Group::spindle, 190, letters('R', 'P', 'Q')},
    Use{Group::in_out, 620, letters('P')},
    Use{Group::in_out, 630, letters('P')},
    Use{Group::in_out, 640, letters('P')},
    Use{Group::in_out, 650, letters('P')},
    Use{Group::in_out, 660, letters('P', 'E', 'L', 'Q')},
    Use{Group::in_out, 670, letters('E', 'Q')},
    Use{Group::in_out, 680, letters('E', 'Q')},
    Use{Group::overrides, 500, letters('P')},
    Use{Group::overrides, 510, letters('P')},
    Use{Group::overrides, 520, letters('P')},
    Use{Group::overrides, 530, letters('P')},
};

}  // namespace

Letters letters_of_codes(const BlockCodes& codes) {
  Letters all = 0;
  for (const Use& use : kUses) {
    all |= codes[use.group] == use.code ? use.letters : 0;
  }
  return all;
}

int users_of(const BlockCodes& codes, char letter) {
  int users = 0;
  for (const Use& use : kUses) {
    const bool takes = (use.letters & letter_bit(letter)) != 0;
    users += takes && codes[use.group] == use.code ? 1 : 0;
  }
  return users;
}

Group taker_of_axes(const BlockWords& block, const BlockCodes& codes) {
  switch (codes[Group::other]) {
    case 100:
    case 280:
    case 300:
    case 520:
    case 920:
      return Group::other;
    default:
      break;
  }
  if (codes[Group::scaling] == 510) {
    return Group::scaling;
  }
  if (codes[Group::program_turn] == 680) {
    return Group::program_turn;
  }
  if (codes.has(Group::mirror)) {
    return Group::mirror;
  }
  return offset_takes_axes(block, codes) ? Group::length_offset : Group::count;
}

bool offset_takes_axes(const BlockWords& block, const BlockCodes& codes) {
  const Tenths code = codes[Group::length_offset];
  return code == 431 || (code == 432 && !block.has('H'));
}

}  // namespace kerf::parser
