// line := ['/' [1-9]] ['N' unsigned] *(word | comment | assignment) [remark]
// word := letter (number | value)
//
// The grammar is Spirit X3 over bytes, with leaves of our own (block_leaves.hpp). It has no
// recursion, so no input can overflow the stack, and it fills the block in place. Values that are
// no plain numbers, and assignments, are the evaluator's: see expressions/.
#include "parser/block/block_grammar.hpp"

#include <algorithm>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/block/block_leaves.hpp"
#include "parser/expressions/expression_scan.hpp"
#include "parser/text/number.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

using namespace leaves;

std::uint32_t offset_in(const BlockWords& block, const char* at) {
  return static_cast<std::uint32_t>(at - block.line.data());
}

[[gnu::noinline]] void note_oddity(BlockWords& block, Word& word, char letter, Oddity oddity) {
  constexpr Letters kCoordinates = letters('X', 'Y', 'Z', 'I', 'J');
  if (oddity == Oddity::blank_inside) {
    block.blank_in_number = block.blank_in_number == 0 ? word.offset + 1 : block.blank_in_number;
  } else if ((kCoordinates & letter_bit(letter)) != 0) {
    word.value = 0.0;
    block.fine_number = block.fine_number == 0 ? word.offset + 1 : block.fine_number;
  } else {
    return;
  }
  block.remarkable = true;
}

// The place for a word whose letter has been before, or is G or M; nullptr where it may not stand
// again.
[[gnu::noinline]] Word* place_for(BlockWords& block, char letter) {
  if (letter == 'G') {
    if (block.g_count == BlockWords::kMaxG) {
      block.stop = Stop::too_many_g;
      return nullptr;
    }
    return &block.g[block.g_count++];
  }
  if (letter == 'M') {
    if (block.m_count == BlockWords::kMaxM) {
      block.stop = Stop::too_many_m;
      return nullptr;
    }
    return &block.m[block.m_count++];
  }
  block.stop = Stop::repeated;
  return nullptr;
}

// What rounding left of a code or a number of something. G codes have tenths [rs274: G[1.00005] is
// G1, G[1.0005] is refused].
double settled(const ScannedNumber& number, char letter) {
  const double value = number.value;
  constexpr Letters kWhole = letters('D', 'H', 'L', 'M', 'O', 'T');
  if (letter == 'G') {
    const double tenths = std::round(value * 10.0);
    return std::fabs(value * 10.0 - tenths) <= 1e-3 ? tenths / 10.0 : value;
  }
  const double tolerance = (kWhole & letter_bit(letter)) != 0 ? 1e-4 : letter == 'P' ? 1e-9 : 0.0;
  const double whole = std::round(value);
  return std::fabs(value - whole) <= tolerance ? whole : value;
}

// A word is stored after one test of its letter's bit; only G, M and a letter that was there
// before need a closer look.
bool store_word(BlockWords& block, const char* at, const ScannedNumber& number) {
  const auto index = static_cast<unsigned>((*at | 0x20) - 'a');
  const Letters bit = Letters{1} << index;
  Word* word = &block.words[index];
  if (((block.present | letters('G', 'M')) & bit) != 0) {
    word = place_for(block, detail::to_upper(*at));
    if (word == nullptr) {
      return false;
    }
  } else {
    block.present |= bit;
  }
  word->value = number.value;
  word->offset = offset_in(block, at);
  word->length = static_cast<std::uint32_t>(number.end - at);
  block.pointed |= static_cast<Letters>(number.point) << index;
  if (block.first_word == BlockWords::kNoWord) {
    block.first_word = word->offset;
  }
  if (number.oddity != Oddity::none) {
    note_oddity(block, *word, detail::to_upper(*at), number.oddity);
  }
  return true;
}

// Fanuc's ROUND means another thing where an address has a least increment.
bool rounds_to_increment(const Evaluator& evaluator, char letter) {
  constexpr Letters kOfIncrements =
      letters('A', 'B', 'C', 'E', 'F', 'I', 'J', 'K', 'Q', 'R', 'U', 'V', 'W', 'X', 'Y', 'Z');
  return evaluator.rounding() != nullptr && rules_of(evaluator.dialect()).least_increments &&
         (kOfIncrements & letter_bit(letter)) != 0;
}

// The same for a value of the evaluator: a vacant one makes no word.
[[gnu::noinline]] bool store_worked_out(const Target& target, const char* at,
                                        ScannedNumber number) {
  BlockWords& block = target.block;
  const char letter = detail::to_upper(*at);
  if (rounds_to_increment(target.evaluator, letter)) {
    block.stop = Stop::value;
    return target.evaluator.fail(
        target.evaluator.rounding(), errors::kRoundInAddress,
        joined({"ROUND in the value of ", named(letter),
                " (Fanuc: to the least increment) is not supported: round in a statement before"}));
  }
  number.value = settled(number, letter);
  return is_vacant(number.value) || store_word(block, at, number);
}

// NOLINTBEGIN(readability-identifier-naming): rules and actions of a grammar, lower case as its
// words.
constexpr auto keep_word = [](auto& context) {
  const char* const at = boost::fusion::at_c<0>(x3::_attr(context));
  const ScannedNumber& number = boost::fusion::at_c<1>(x3::_attr(context));
  x3::_pass(context) = number.worked_out ? store_worked_out(target_of(context), at, number)
                                         : store_word(target_of(context).block, at, number);
};
constexpr auto keep_line_number = [](auto& context) {
  const auto& parts = x3::_attr(context);
  const char* const at = boost::fusion::at_c<0>(parts);
  BlockWords& block = target_of(context).block;
  const ScannedNumber& number = boost::fusion::at_c<1>(parts);
  const auto* const sign = std::find(at, number.end, '-');
  x3::_pass(context) = sign == number.end && store_word(block, at, number);
  block.line_number_decimal = number.point;
  block.remarkable = block.remarkable || number.point;
};
constexpr auto keep_delete = [](auto& context) { target_of(context).block.deleted = true; };
constexpr auto keep_delete_switch = [](auto& context) {
  target_of(context).block.numbered_delete = target_of(context).block.remarkable = true;
};
constexpr auto keep_comment = [](auto& context) {
  BlockWords& block = target_of(context).block;
  block.comment = offset_in(block, x3::_attr(context)) + 1;
};
constexpr auto keep_remark = [](auto& context) {
  BlockWords& block = target_of(context).block;
  block.remark = offset_in(block, x3::_attr(context)) + 1;
  block.remarkable = true;
};

const Blanks blanks{};
const Letter letter{};
const PlainNumber number{};
const Value value{};
const Assignment assignment{};
const ReadPosition here{};
const CommentByte inside_brackets{};
const CommentByte to_the_end = byte_of_remark();

const auto comment = (here >> x3::lit('('))[keep_comment] >> x3::omit[*inside_brackets] >>
                     x3::lit(')') >> blanks;
const auto remark = (here >> x3::lit(';'))[keep_remark] >> x3::omit[*to_the_end];
const auto word = (letter >> value)[keep_word] >> blanks;
const auto line_number =
    (here >> x3::omit[x3::lit('N') | x3::lit('n')] >> blanks >> number)[keep_line_number] >> blanks;
const auto block_delete = x3::lit('/')[keep_delete] >>
                          -(x3::char_('1', '9')[keep_delete_switch]) >> blanks;
// False: the line is not complete.
[[gnu::noinline]] bool finish_assignments(BlockWords& block, Evaluator& evaluator) {
  evaluator.commit();
  block.stale_read = evaluator.stale_read();
  block.remarkable = true;
  if (block.stopped_at != block.line.size()) {
    return false;
  }
  const bool alone = (block.present & ~letter_bit('N')) == 0 && block.g_count + block.m_count == 0;
  if (rules_of(evaluator.dialect()).assigns_at_once && !alone) {
    evaluator.fail(block.line.data() + block.assignment - 1, errors::kAssignmentBesideWords,
                   "an assignment must stand alone in its block");
    block.stop = Stop::value;
    return false;
  }
  return true;
}

const auto line = blanks >> -block_delete >> -line_number >>
                  *(word | comment | (assignment >> blanks)) >> -remark;
// NOLINTEND(readability-identifier-naming)

}  // namespace

bool read_block(std::string_view text, BlockWords& block, Evaluator& evaluator) {
  block.clear(text);
  evaluator.begin_line();
  const char* at = text.data();
  const char* const end = at + text.size();
  const Target target{block, evaluator};
  const auto surroundings = std::cref(target);
  line.parse(at, end, x3::make_context<TargetTag>(surroundings), x3::unused, x3::unused);
  block.stopped_at = offset_in(block, at);
  block.fault = &evaluator.fault();
  return block.assignment == 0 ? at == end : finish_assignments(block, evaluator);
}

}  // namespace kerf::parser
