#include "parser/modal/codes.hpp"

#include <algorithm>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

enum class Status : std::uint8_t { unknown, refused, fanuc, known };

struct Code {
  Status status = Status::unknown;
  Group group = Group::other;
};

constexpr std::size_t kCodes = 1000;  // up to 99.9
using Table = std::array<Code, kCodes>;

constexpr bool is_m_group(Group group) {
  return group >= Group::stop;
}

template <std::size_t kSize>
constexpr void know(Table& table, Group group, const std::array<int, kSize>& tenths) {
  for (const int code : tenths) {
    table[static_cast<std::size_t>(code)] = {Status::known, group};
  }
}

template <std::size_t kSize>
constexpr void know_fanuc(Table& table, Group group, const std::array<int, kSize>& tenths) {
  for (const int code : tenths) {
    table[static_cast<std::size_t>(code)] = {Status::fanuc, group};
  }
}

template <std::size_t kSize>
constexpr void refuse(Table& table, const std::array<int, kSize>& tenths) {
  for (const int code : tenths) {
    table[static_cast<std::size_t>(code)].status = Status::refused;
  }
}

constexpr Table g_table() {
  Table table{};
  know(table, Group::other, std::array{40, 100, 280, 281, 300, 301, 520, 530, 920});
  know(table, Group::motion, std::array{0, 10, 20, 30, 50, 51, 52, 53, 62, 63, 382, 383, 384, 385});
  know(table, Group::motion, std::array{730, 740, 810, 820, 830, 840, 850, 860, 870, 880, 890});
  know(table, Group::retract, std::array{980, 990});
  know(table, Group::cycle, std::array{800});
  know(table, Group::plane, std::array{170, 180, 190});
  know(table, Group::distance, std::array{900, 910});
  know(table, Group::arc_distance, std::array{901, 911});
  know(table, Group::feed_mode, std::array{930, 940, 950});
  know(table, Group::units, std::array{200, 210});
  know(table, Group::cutter_compensation, std::array{400, 410, 411, 420, 421});
  know(table, Group::length_offset, std::array{430, 431, 432, 490});
  know(table, Group::work_offset, std::array{540, 550, 560, 570, 580, 590, 591, 592, 593});
  know(table, Group::path, std::array{610, 611, 640});
  know(table, Group::spindle_mode, std::array{960, 970});
  know(table, Group::local_offset, std::array{921, 922, 923});
  know_fanuc(table, Group::work_offset, std::array{541});
  know_fanuc(table, Group::length_offset, std::array{440});
  know_fanuc(table, Group::scaling, std::array{500, 510});
  know_fanuc(table, Group::mirror, std::array{501, 511});
  know_fanuc(table, Group::program_turn, std::array{680, 690});
  refuse(table,
         std::array{150, 160, 330, 331, 650, 660, 670, 700, 710, 711, 712, 720, 721, 722, 760});
  return table;
}

constexpr Table m_table() {
  Table table{};
  know(table, Group::stop, std::array{0, 10, 20, 300, 600});
  know(table, Group::tool, std::array{60, 610});
  know(table, Group::spindle, std::array{30, 40, 50, 190});
  know(table, Group::coolant, std::array{70, 80, 90});
  know(table, Group::in_out, std::array{620, 630, 640, 650, 660, 670, 680});
  know(table, Group::overrides, std::array{480, 490, 500, 510, 520, 530});
  know(table, Group::state, std::array{700, 710, 720, 730});
  refuse(table, std::array{980, 990});
  return table;
}

constexpr Table kG = g_table();
constexpr Table kM = m_table();

bool is_printer_code(double m) {
  constexpr std::array kKnown{82,  83,  84,  104, 105, 106, 107, 109,
                              117, 140, 190, 201, 203, 204, 205};
  return std::any_of(kKnown.begin(), kKnown.end(), [m](int known) { return m == known; });
}

// The code's place in its table; kCodes where it has none.
std::size_t place_of(double value) {
  const double tenths = value * 10.0;
  const double whole = std::nearbyint(tenths);
  if (!(whole >= 0.0 && whole < static_cast<double>(kCodes)) || std::fabs(tenths - whole) > 1e-9) {
    return kCodes;
  }
  return static_cast<std::size_t>(whole);
}

// Why a known G code is not run.
std::string_view reason_for(double g, const DialectRules& rules) {
  if (g == 76.0 && rules.control_codes) {
    return " (fine boring: the way aside is a parameter of the control): write the moves out";
  }
  if (g == 15.0 || g == 16.0) {
    return " (polar coordinates)";
  }
  if (g >= 33.0 && g < 34.0) {
    return " (motion in step with the spindle needs the spindle's encoder)";
  }
  return (g >= 70.0 && g < 73.0) || g == 76.0 ? " (a cycle of lathes)" : "";
}

diagnostics::Failure why_not(const BlockWords& block, const Word& word, const Code& code, bool is_m,
                             const DialectRules& rules) {
  const std::string name = upper(block.text(word));
  if (!is_m && (word.value == 7.0 || word.value == 8.0)) {
    return diagnostics::fail(
        word.offset, errors::kLatheCode,
        name + " (diameter or radius on X) is for lathes, this machine is a mill");
  }
  if (code.status == Status::fanuc) {
    return diagnostics::fail(word.offset, errors::kFanucCode,
                             name + " is a code of the Fanuc dialect");
  }
  if (code.status == Status::refused) {
    return diagnostics::fail(word.offset, errors::kCodeNotSupported,
                             joined({name, " is not supported", reason_for(word.value, rules)}));
  }
  if (!is_m) {
    return diagnostics::fail(word.offset, errors::kUnknownGCode, name + " is not known");
  }
  if (word.value >= 0.0 && word.value != std::floor(word.value)) {
    return diagnostics::fail(word.offset, errors::kDecimalMCode,
                             name + ": an M code must be a whole number");
  }
  if (is_printer_code(word.value)) {
    return diagnostics::fail(word.offset, errors::kPrinterCode,
                             name + " is not known (3D-printer file?)");
  }
  return diagnostics::fail(word.offset, errors::kUnknownMCode, name + " is not known");
}

// Fanuc has cycles and G80 in a group of their own (09).
Group group_of(const Code& code, std::size_t place, const DialectRules& rules) {
  const bool cycle =
      rules.cycle_group && code.group == Group::motion && is_cycle(static_cast<Motion>(place));
  return cycle ? Group::cycle : code.group;
}

// A motion goes before G80. Of a motion and a cycle, with Fanuc, the one that is written last
// counts; the other takes its place in the cycle's group.
void join_cycle_and_motion(const BlockWords& block, BlockCodes& codes) {
  constexpr Tenths kG80 = 800;
  auto& motion = codes.by_group[static_cast<std::size_t>(Group::motion)];
  auto& cycle = codes.by_group[static_cast<std::size_t>(Group::cycle)];
  if (motion.tenths == kNoCode) {
    motion = cycle;
  } else if (cycle.tenths != kNoCode && cycle.tenths != kG80 &&
             block.g[cycle.index].offset > block.g[motion.index].offset) {
    std::swap(motion, cycle);
  }
}

template <std::size_t kSize>
diagnostics::Done sort_words(const BlockWords& block, const std::array<Word, kSize>& words,
                             std::size_t count, bool is_m, const DialectRules& rules,
                             BlockCodes& codes) {
  for (std::size_t i = 0; i < count; ++i) {
    const Word& word = words[i];
    const std::size_t place = place_of(word.value);
    const Code code = place < kCodes ? (is_m ? kM : kG)[place] : Code{};
    const bool known =
        code.status == Status::known || (code.status == Status::fanuc && rules.control_codes);
    if (!known) {
      return why_not(block, word, code, is_m, rules);
    }
    const Group group = is_m ? code.group : group_of(code, place, rules);
    BlockCodes::Entry& entry = codes.by_group[static_cast<std::size_t>(group)];
    if (entry.tenths != kNoCode) {
      return diagnostics::fail(word.offset, errors::kSameModalGroup,
                               joined({upper(block.text(words[entry.index])), " and ",
                                       upper(block.text(word)), " are in the same modal group"}));
    }
    entry = {static_cast<Tenths>(place), static_cast<std::uint8_t>(i)};
  }
  return {};
}

}  // namespace

diagnostics::Done sort_some_codes(const BlockWords& block, const DialectRules& rules,
                                  BlockCodes& codes) {
  if (codes.filled) {
    codes = {};
  }
  if (block.g_count + block.m_count == 0) {
    return {};
  }
  codes.filled = true;
  diagnostics::Done g = sort_words(block, block.g, block.g_count, false, rules, codes);
  diagnostics::Done m = sort_words(block, block.m, block.m_count, true, rules, codes);
  if (codes.has(Group::cycle)) {
    join_cycle_and_motion(block, codes);
  }
  return !m && (g || m.error()->offset < g.error()->offset) ? std::move(m) : std::move(g);
}

const Word& code_word(const BlockWords& block, const BlockCodes& codes, Group group) {
  const std::size_t index = codes.by_group[static_cast<std::size_t>(group)].index;
  return is_m_group(group) ? block.m[index] : block.g[index];
}

}  // namespace kerf::parser
