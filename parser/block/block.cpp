#include "parser/block/block.hpp"

namespace kerf::parser {

const Word* leftmost(const BlockWords& block, Letters set) {
  const Word* first = nullptr;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((set & letter_bit(letter)) != 0 && block.has(letter) &&
        (first == nullptr || block.word(letter).offset < first->offset)) {
      first = &block.word(letter);
    }
  }
  return first;
}

char letter_of(const BlockWords& block, const Word& word) {
  return static_cast<char>(block.line[word.offset] & ~0x20);
}

}  // namespace kerf::parser
