// Random part-program text that is mostly right: blocks, o-words in pairs, macro statements,
// expressions. What is wrong in it is what a fuzzer wants to be wrong: a value, a word too many.
#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace kerf::fuzz {

class BlockGenerator {
 public:
  explicit BlockGenerator(std::uint32_t seed) : random_(seed) {}

  // One or more whole lines, each with its line end.
  std::string lines();
  // What may follow a letter: a number, a parameter, an expression in brackets.
  std::string value();
  std::string word();

 private:
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(random_() % count); }
  bool one_in(std::uint32_t count) { return below(count) == 0; }
  std::string number();
  std::string parameter();
  std::string expression(int depth);
  std::string operand(int depth);
  std::string block();
  std::string assignment();
  std::string o_word_group(int depth);
  std::string macro_group(int depth);
  std::string body(int depth);
  std::string curve();
  std::string cycle();

  std::minstd_rand random_;
};

}  // namespace kerf::fuzz
