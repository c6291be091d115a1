#include "parser/dialects/fanuc/fanuc_codes.hpp"

namespace kerf::parser {

namespace {

bool has_g(const BlockWords& block, double code) {
  for (std::size_t i = 0; i < block.g_count; ++i) {
    if (block.g[i].value == code) {
      return true;
    }
  }
  return false;
}

bool is_in_inches(const BlockWords& block, const ModalState& state) {
  return has_g(block, 20.0) || (state.units == Units::inch && !has_g(block, 21.0));
}

bool has_cycle(const BlockWords& block, const ModalState& state) {
  bool moves = false;
  for (std::size_t i = 0; i < block.g_count; ++i) {
    const double g = block.g[i].value;
    if (g == 73.0 || g == 74.0 || (g >= 81.0 && g <= 89.0)) {
      return true;
    }
    moves = moves || (g >= 0.0 && g <= 3.0);
  }
  return !moves && is_cycle(state.motion);
}

// Letters whose numbers are lengths, or angles of A, B and C, in this block.
Letters lengths_of(const BlockWords& block, const ModalState& state) {
  Letters lengths =
      letters('X', 'Y', 'Z', 'I', 'J', 'K', 'R', 'Q', 'U', 'V', 'W') | letters('A', 'B', 'C');
  if (has_cycle(block, state)) {
    lengths &= ~letters('K');  // repeats
  }
  if (has_g(block, 51.0)) {
    lengths &= ~letters('I', 'J', 'K');  // factors, which count in thousandths by themselves
  }
  if (has_g(block, 5.1) || has_g(block, 10.0)) {
    lengths &= ~letters('Q');
  }
  for (std::size_t i = 0; i < block.m_count; ++i) {
    if (block.m[i].value != 0.0) {
      lengths &= ~letters('Q', 'R');  // of M19, M61, M66 to M68
    }
  }
  return lengths;
}

}  // namespace

void count_in_least_increments(const ModalState& state, double least_increment_mm,
                               BlockWords& block) {
  const double length = is_in_inches(block, state) ? least_increment_mm * 0.1 : least_increment_mm;
  constexpr double kThousandth = 0.001;
  const bool waits = has_g(block, 4.0);
  const bool turns = has_g(block, 68.0);
  const Letters lengths = lengths_of(block, state);
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((lengths & letter_bit(letter)) == 0 || !block.has(letter)) {
      continue;
    }
    Word& word = block.words[static_cast<std::size_t>(letter - 'A')];
    if (block.text(word).find_first_of(".[#") != std::string_view::npos) {
      continue;
    }
    const bool thousandths = waits || (turns && letter == 'R');
    const bool is_angle = letter <= 'C';
    word.value *= thousandths ? kThousandth : is_angle ? least_increment_mm : length;
  }
}

}  // namespace kerf::parser
