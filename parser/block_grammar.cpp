// line := ['/' [1-9]] ['N' unsigned] *(word | comment | assignment) [remark]
// word := letter (number | value)
//
// The grammar is Spirit X3 over bytes. Its leaves are ours: X3's own number parsers take nan, inf
// and exponents and round wrongly, and its character classes must not see bytes from 0x80. It has
// no recursion, so no input can overflow the stack, and it fills the block in place. Values that
// are no plain numbers, and assignments, are the evaluator's: see expressions/.
#include "parser/block_grammar.hpp"

#include <algorithm>
#include <cmath>

#include <boost/spirit/home/x3.hpp>

#include "parser/errors/fanuc.hpp"
#include "parser/errors/variables.hpp"
#include "parser/expressions/expression_scan.hpp"
#include "parser/number.hpp"
#include "parser/text.hpp"

namespace kerf::parser {

namespace {

namespace x3 = boost::spirit::x3;

struct BlockTag {};

constexpr bool is_letter(char c) {
  return static_cast<unsigned char>((c | 0x20) - 'a') < 26;
}
constexpr char to_upper(char c) {
  return static_cast<char>(c & ~0x20);
}

struct Target {
  Block& block;
  Evaluator& evaluator;
};
template <class Context>
Block& block_of(const Context& context) {
  return x3::get<BlockTag>(context).get().block;
}

std::uint32_t offset_in(const Block& block, const char* at) {
  return static_cast<std::uint32_t>(at - block.line.data());
}

struct Blanks : x3::parser<Blanks> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;
  template <class Iterator, class Context, class RContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RContext&, Attribute&) const {
    while (first != last && detail::is_blank(*first)) {
      ++first;
    }
    return true;
  }
};

// A byte of a comment: all but NUL and, between brackets, the brackets.
struct CommentByte : x3::parser<CommentByte> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;
  bool brackets = false;
  template <class Iterator, class Context, class RContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RContext&, Attribute&) const {
    if (first == last || *first == '\0' || (!brackets && (*first == '(' || *first == ')'))) {
      return false;
    }
    ++first;
    return true;
  }
};

// An address letter other than N, which has its own place.
struct Letter : x3::parser<Letter> {
  using attribute_type = const char*;
  static constexpr bool has_attribute = true;
  template <class Iterator, class Context, class RContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RContext&,
             Attribute& at) const {
    if (first == last || !is_letter(*first) || to_upper(*first) == 'N') {
      return false;
    }
    at = first++;
    return true;
  }
};

struct Number : x3::parser<Number> {
  using attribute_type = ScannedNumber;
  static constexpr bool has_attribute = true;
  template <class Iterator, class Context, class RContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RContext&,
             Attribute& number) const {
    number = scan_number(first, last);
    if (number.end == nullptr) {
      return false;
    }
    first = number.end;
    return true;
  }
};

// A word's value that is not a number straight behind its letter. Out of the way of plain blocks.
[[gnu::noinline]] bool read_other_value(const Target& target, const char*& at,
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
  number = {number.value, at, false, true, true};
  return true;
}

struct Value : x3::parser<Value> {
  using attribute_type = ScannedNumber;
  static constexpr bool has_attribute = true;
  template <class Iterator, class Context, class RContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RContext&,
             Attribute& number) const {
    // '+' to '9': the signs, the point, the digits, and ',' and '/', which no value begins with.
    if (first != last && static_cast<unsigned char>(*first - '+') <= '9' - '+') {
      number = scan_number(first, last);
      if (number.end != nullptr) {
        first = number.end;
        return true;
      }
    }
    return read_other_value(x3::get<BlockTag>(context).get(), first, number);
  }
};

struct Assignment : x3::parser<Assignment> {
  using attribute_type = x3::unused_type;
  static constexpr bool has_attribute = false;
  template <class Iterator, class Context, class RContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RContext&,
             Attribute&) const {
    return first != last && *first == '#' &&
           read_assignment(x3::get<BlockTag>(context).get(), first);
  }
  [[gnu::noinline]] static bool read_assignment(const Target& target, const char*& at) {
    Block& block = target.block;
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
};

// Where the grammar is, without taking anything.
struct Here : x3::parser<Here> {
  using attribute_type = const char*;
  static constexpr bool has_attribute = true;
  template <class Iterator, class Context, class RContext, class Attribute>
  bool parse(Iterator& first, const Iterator&, const Context&, RContext&, Attribute& at) const {
    at = first;
    return true;
  }
};

[[gnu::noinline]] void note_blank(Block& block, std::uint32_t offset) {
  if (block.blank_in_number == 0) {
    block.blank_in_number = offset + 1;
    block.remarkable = true;
  }
}

// The place for a word whose letter has been before, or is G or M; nullptr where it may not stand
// again.
[[gnu::noinline]] Word* place_for(Block& block, char letter) {
  if (letter == 'G') {
    if (block.g_count == Block::kMaxG) {
      block.stop = Stop::too_many_g;
      return nullptr;
    }
    return &block.g[block.g_count++];
  }
  if (letter == 'M') {
    if (block.m_count == Block::kMaxM) {
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
double settled(char letter, double value) {
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
bool store_word(Block& block, const char* at, const ScannedNumber& number) {
  const auto index = static_cast<unsigned>((*at | 0x20) - 'a');
  const Letters bit = Letters{1} << index;
  Word* word = &block.words[index];
  if (((block.present | letters('G', 'M')) & bit) != 0) {
    word = place_for(block, to_upper(*at));
    if (word == nullptr) {
      return false;
    }
  } else {
    block.present |= bit;
  }
  word->value = number.value;
  word->offset = offset_in(block, at);
  word->length = static_cast<std::uint32_t>(number.end - at);
  block.pointed |= Letters{number.point} << index;
  if (block.first_word == Block::kNoWord) {
    block.first_word = word->offset;
  }
  if (number.blank_inside) {
    note_blank(block, word->offset);
  }
  return true;
}

// Fanuc's ROUND means another thing where an address has a least increment.
bool rounds_to_increment(const Evaluator& evaluator, char letter) {
  constexpr Letters kOfIncrements =
      letters('A', 'B', 'C', 'E', 'F', 'I', 'J', 'K', 'Q', 'R', 'U', 'V', 'W', 'X', 'Y', 'Z');
  return evaluator.rounding() != nullptr && evaluator.dialect() == Dialect::fanuc &&
         (kOfIncrements & letter_bit(letter)) != 0;
}

// The same for a value of the evaluator: a vacant one makes no word.
[[gnu::noinline]] bool store_worked_out(const Target& target, const char* at,
                                        ScannedNumber number) {
  Block& block = target.block;
  const char letter = to_upper(*at);
  if (rounds_to_increment(target.evaluator, letter)) {
    block.stop = Stop::value;
    return target.evaluator.fail(
        target.evaluator.rounding(), errors::kRoundInAddress,
        joined({"ROUND in the value of ", named(letter),
                " (Fanuc: to the least increment) is not supported: round in a statement before"}));
  }
  number.value = settled(letter, number.value);
  return is_vacant(number.value) || store_word(block, at, number);
}

constexpr auto keep_word = [](auto& context) {
  const char* const at = boost::fusion::at_c<0>(x3::_attr(context));
  const ScannedNumber& number = boost::fusion::at_c<1>(x3::_attr(context));
  x3::_pass(context) = number.worked_out
                           ? store_worked_out(x3::get<BlockTag>(context).get(), at, number)
                           : store_word(block_of(context), at, number);
};
constexpr auto keep_line_number = [](auto& context) {
  const auto& parts = x3::_attr(context);
  const char* const at = boost::fusion::at_c<0>(parts);
  Block& block = block_of(context);
  const ScannedNumber& number = boost::fusion::at_c<1>(parts);
  const auto* const sign = std::find(at, number.end, '-');
  x3::_pass(context) = sign == number.end && store_word(block, at, number);
  block.line_number_decimal = number.point;
  block.remarkable = block.remarkable || number.point;
};
constexpr auto keep_delete = [](auto& context) { block_of(context).deleted = true; };
constexpr auto keep_delete_switch = [](auto& context) {
  block_of(context).numbered_delete = block_of(context).remarkable = true;
};
constexpr auto keep_comment = [](auto& context) { block_of(context).has_comment = true; };
constexpr auto keep_remark = [](auto& context) {
  Block& block = block_of(context);
  block.remark = offset_in(block, x3::_attr(context)) + 1;
  block.remarkable = true;
};

const Blanks blanks{};
const Letter letter{};
const Number number{};
const Value value{};
const Assignment assignment{};
const Here here{};
const CommentByte inside_brackets{};
const CommentByte to_the_end{{}, true};

const auto comment = x3::lit('(')[keep_comment] >> x3::omit[*inside_brackets] >>
                     x3::lit(')') >> blanks;
const auto remark = (here >> x3::lit(';'))[keep_remark] >> x3::omit[*to_the_end];
const auto word = (letter >> value)[keep_word] >> blanks;
const auto line_number =
    (here >> x3::omit[x3::lit('N') | x3::lit('n')] >> blanks >> number)[keep_line_number] >> blanks;
const auto block_delete = x3::lit('/')[keep_delete] >>
                          -(x3::char_('1', '9')[keep_delete_switch]) >> blanks;
// False: the line is not complete.
[[gnu::noinline]] bool finish_assignments(Block& block, Evaluator& evaluator) {
  evaluator.commit();
  block.stale_read = evaluator.stale_read();
  block.remarkable = true;
  if (block.stopped_at != block.line.size()) {
    return false;
  }
  const bool alone = (block.present & ~letter_bit('N')) == 0 && block.g_count + block.m_count == 0;
  if (evaluator.dialect() == Dialect::fanuc && !alone) {
    evaluator.fail(block.line.data() + block.assignment - 1, errors::kAssignmentBesideWords,
                   "an assignment must stand alone in its block");
    block.stop = Stop::value;
    return false;
  }
  return true;
}

const auto line = blanks >> -block_delete >> -line_number >>
                  *(word | comment | (assignment >> blanks)) >> -remark;

}  // namespace

bool read_block(std::string_view text, Block& block, Evaluator& evaluator) {
  block.clear(text);
  evaluator.begin_line();
  const char* at = text.data();
  const char* const end = at + text.size();
  const Target target{block, evaluator};
  const auto surroundings = std::cref(target);
  line.parse(at, end, x3::make_context<BlockTag>(surroundings), x3::unused, x3::unused);
  block.stopped_at = offset_in(block, at);
  block.fault = &evaluator.fault();
  return block.assignment == 0 ? at == end : finish_assignments(block, evaluator);
}

}  // namespace kerf::parser
