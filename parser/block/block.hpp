// One line of a program as words, in fixed places: filling it never allocates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "parser/text/letters.hpp"

namespace kerf::diagnostics {
struct Fault;
}

namespace kerf::parser {

struct Word {
  double value = 0.0;
  std::uint32_t offset = 0;  // of the letter, in bytes from the start of the line
  std::uint32_t length = 0;  // letter and number; blanks between them included
};

// Why the grammar stopped before the end of the line, where the bytes alone do not show it.
enum class Stop : std::uint8_t { none, repeated, too_many_g, too_many_m, value };

struct BlockWords {
  static constexpr std::size_t kMaxG = 16;
  static constexpr std::size_t kMaxM = 4;
  static constexpr std::uint32_t kNoWord = 0xFFFFFFFF;

  std::string_view line;
  Letters present = 0;  // of the words in `words`; G and M are counted apart
  // Words whose value has a decimal point or was worked out; what is left may be meant in least
  // increments.
  Letters pointed = 0;
  std::uint8_t g_count = 0;
  std::uint8_t m_count = 0;
  Stop stop = Stop::none;
  bool deleted = false;          // began with '/'
  bool numbered_delete = false;  // /1 to /9
  bool line_number_decimal = false;
  bool remarkable = false;            // one of the things below that are worth a warning
  std::uint32_t stopped_at = 0;       // offset of what the grammar did not take
  std::uint32_t blank_in_number = 0;  // offset + 1 of the first word with a blank inside its number
  std::uint32_t fine_number = 0;      // offset + 1 of the first coordinate that is fine, read as 0
  std::uint32_t comment = 0;          // offset + 1 of the last '(' comment
  std::uint32_t remark = 0;           // offset + 1 of a ';' comment
  std::uint32_t first_word = kNoWord;         // offset of the first word, or kNoWord
  std::uint32_t assignment = 0;               // offset + 1 of the first assignment to a variable
  std::uint32_t stale_read = 0;               // offset + 1 of a variable read after its assignment
  const diagnostics::Fault* fault = nullptr;  // the evaluator's, with Stop::value
  std::array<Word, kMaxG> g;
  std::array<Word, kMaxM> m;
  std::array<Word, 26> words;

  void clear(std::string_view text) {
    line = text;
    present = pointed = 0;
    g_count = m_count = 0;
    stop = Stop::none;
    deleted = numbered_delete = line_number_decimal = remarkable = false;
    stopped_at = blank_in_number = fine_number = comment = remark = assignment = stale_read = 0;
    first_word = kNoWord;
    fault = nullptr;
  }
  [[nodiscard]] bool has(char upper_case) const { return (present & letter_bit(upper_case)) != 0; }
  [[nodiscard]] bool has_any(Letters set) const { return (present & set) != 0; }
  [[nodiscard]] const Word& word(char upper_case) const {
    return words[static_cast<std::size_t>(upper_case - 'A')];
  }
  [[nodiscard]] double value(char upper_case) const { return word(upper_case).value; }
  [[nodiscard]] double value_or(char upper_case, double otherwise) const {
    return has(upper_case) ? value(upper_case) : otherwise;
  }
  [[nodiscard]] bool empty() const { return present == 0 && g_count == 0 && m_count == 0; }
  // The word as it was written.
  [[nodiscard]] std::string_view text(const Word& word) const {
    return line.substr(word.offset, word.length);
  }
};

// The first word of `set` in the order of the line; nullptr where there is none.
const Word* leftmost(const BlockWords& block, Letters set);
// The capital letter of a word.
char letter_of(const BlockWords& block, const Word& word);

}  // namespace kerf::parser
