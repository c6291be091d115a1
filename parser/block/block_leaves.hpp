// The leaves of the grammar of blocks. Part of block_grammar.cpp and of nothing else.
#pragma once

#include <string_view>

#include "parser/block/block.hpp"
#include "parser/expressions/evaluator.hpp"
#include "parser/expressions/expression_scan.hpp"
#include "parser/expressions/grammar_leaf.hpp"
#include "parser/text/number.hpp"

namespace kerf::parser::leaves {

// What is filled, and who works out what is no plain number.
struct Target {
  BlockWords& block;
  Evaluator& evaluator;
};
struct TargetTag {};
template <class Context>
const Target& target_of(const Context& context) {
  return x3::get<TargetTag>(context).get();
}

// A byte of a comment: all but NUL and, between brackets, the brackets.
struct CommentByte : Leaf<CommentByte, Nothing> {
  bool brackets = false;
  template <class Context>
  bool operator()(const GrammarPlace<Context>& place, Nothing&) const {
    if (place.at == place.end || *place.at == '\0' ||
        (!brackets && (*place.at == '(' || *place.at == ')'))) {
      return false;
    }
    ++place.at;
    return true;
  }
};
constexpr CommentByte byte_of_remark() {
  CommentByte leaf;
  leaf.brackets = true;
  return leaf;
}

// An address letter other than N, which has its own place.
struct Letter : Leaf<Letter, const char*> {
  template <class Context>
  bool operator()(const GrammarPlace<Context>& place, const char*& at) const {
    if (place.at == place.end || !detail::is_letter(*place.at) ||
        detail::to_upper(*place.at) == 'N') {
      return false;
    }
    at = place.at++;
    return true;
  }
};

struct PlainNumber : Leaf<PlainNumber, ScannedNumber> {
  template <class Context>
  bool operator()(const GrammarPlace<Context>& place, ScannedNumber& number) const {
    number = scan_number(place.at, place.end);
    if (number.end == nullptr) {
      return false;
    }
    place.at = number.end;
    return true;
  }
};

// A word's value that is not a number straight after its letter. Out of the way of plain blocks.
[[gnu::noinline]] inline bool read_other_value(const Target& target, const char*& at,
                                               ScannedNumber& number) {
  const std::string_view line = target.block.line;
  const char* const end = line.data() + line.size();
  at = skip_blanks(at, end);
  number = scan_number(at, end);
  if (number.end != nullptr) {
    at = number.end;
    return true;
  }
  Cursor cursor{line, static_cast<std::size_t>(at - line.data())};
  if (!target.evaluator.value_begins(cursor)) {
    return false;
  }
  if (!target.evaluator.read_value(cursor, number.value)) {
    target.block.stop = Stop::value;
    return false;
  }
  at = cursor.position();
  number = {number.value, at, Oddity::none, true, true};
  return true;
}

struct Value : Leaf<Value, ScannedNumber> {
  template <class Context>
  bool operator()(const GrammarPlace<Context>& place, ScannedNumber& number) const {
    // '+' to '9': the signs, the point, the digits, and ',' and '/', which no value begins with.
    if (place.at != place.end && static_cast<unsigned char>(*place.at - '+') <= '9' - '+') {
      number = scan_number(place.at, place.end);
      if (number.end != nullptr) {
        place.at = number.end;
        return true;
      }
    }
    return read_other_value(target_of(place.context), place.at, number);
  }
};

[[gnu::noinline]] inline bool read_assignment(const Target& target, const char*& at) {
  BlockWords& block = target.block;
  Cursor cursor{block.line, static_cast<std::size_t>(at - block.line.data())};
  if (block.assignment == 0) {
    block.assignment = static_cast<std::uint32_t>(cursor.at) + 1;
  }
  if (!target.evaluator.read_assignment(cursor)) {
    block.stop = Stop::value;
    return false;
  }
  at = cursor.position();
  return true;
}

struct Assignment : Leaf<Assignment, Nothing> {
  template <class Context>
  bool operator()(const GrammarPlace<Context>& place, Nothing&) const {
    return place.at != place.end && *place.at == '#' &&
           read_assignment(target_of(place.context), place.at);
  }
};

// Where the grammar is, without taking anything.
struct ReadPosition : Leaf<ReadPosition, const char*> {
  template <class Context>
  bool operator()(const GrammarPlace<Context>& place, const char*& at) const {
    at = place.at;
    return true;
  }
};

}  // namespace kerf::parser::leaves
