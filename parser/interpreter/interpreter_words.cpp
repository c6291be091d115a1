// Which words a block may have, and what is said of the others.
#include <cmath>

#include "diagnostics/errors/blocks.hpp"
#include "diagnostics/errors/offsets.hpp"
#include "parser/cycles/drill_cycle.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/modal/word_users.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG4 = 40;
constexpr Tenths kG53 = 53;  // G5.3
constexpr Tenths kG53Machine = 530;
constexpr Tenths kG63 = 63;  // G6.3
constexpr Tenths kG80 = 800;
constexpr double kLargestLineNumber = 99'999'999.0;

// Letters that the motion takes beside the axes.
Letters letters_of(Motion motion, Dialect dialect) {
  switch (motion) {
    case Motion::arc_clockwise:
    case Motion::arc_counterclockwise:
      return letters('I', 'J', 'K', 'R', 'P');
    case Motion::cubic_spline:
      return letters('I', 'J', 'P', 'Q');
    case Motion::quadratic_spline:
      return letters('I', 'J', 'Q');
    default:
      return is_cycle(motion) ? letters_of_cycle(motion, dialect) : 0;
  }
}

}  // namespace

// These are parts of check_words(), a call for each block would be felt.
[[gnu::always_inline]] inline Letters Interpreter::usable_letters(Letters of_motion) const {
  const Letters always = letters('N', 'F', 'S', 'T', 'O') | axis_letters() | of_motion;
  if (block_->g_count + block_->m_count == 0) {
    return always;
  }
  return always | letters_of_codes(codes_) | (dialect_ == Dialect::fanuc ? letters_of_fanuc() : 0);
}

[[gnu::always_inline]] inline bool Interpreter::check_line_number() {
  if (!block_->has('N') || block_->value('N') <= kLargestLineNumber) {
    return true;
  }
  const Word& word = block_->word('N');
  return fail(
      word.offset, errors::kLineNumberOutOfRange,
      joined({"N: line number ", upper(block_->text(word).substr(1, 40)), " is out of range"}));
}

// Words that somebody uses: no two may, and their values must be coordinates at most.
[[gnu::always_inline]] inline bool Interpreter::check_parameters(Letters of_motion) {
  const bool taken = axis_taker_ != Group::count;
  const Letters ranged = letters('I', 'J', 'K', 'P', 'Q', 'R') | (taken ? axis_letters() : 0);
  return !block_->has_any(ranged) || (check_users(of_motion) && check_ranges(ranged));
}

// Every word of the block must have somebody who uses it.
bool Interpreter::check_words() {
  const Block& block = *block_;
  const Tenths code = codes_[Group::motion];
  const Motion motion = code == kNoCode ? state_.motion : static_cast<Motion>(code);
  axis_taker_ = block.g_count > 0 ? taker_of_axes(block, codes_) : Group::count;
  if (dialect_ == Dialect::fanuc && codes_[Group::other] == kG4) {
    axis_taker_ = Group::other;  // X is a time
  }
  const bool moves =
      axis_taker_ == Group::count &&
      (code != kNoCode || block.has_any(axis_letters() | letters('I', 'J', 'K', 'R')));
  const Letters of_motion = moves ? letters_of(motion, dialect_) : 0;
  if (Letters unused = block.present & ~usable_letters(of_motion); unused != 0) {
    warn_idle_offset_numbers(unused);
    unused &= ~letters('D', 'H');
    if (unused != 0) {
      return explain_unused(*leftmost(block, unused));
    }
  }
  if (!check_line_number() || !check_parameters(of_motion)) {
    return false;
  }
  if (axis_taker_ != Group::count) {
    return check_axis_taker(axis_taker_);
  }
  const bool turns = codes_[Group::spindle] == 190;  // M19 R
  return !block.has_any(axis_letters() | letters('I', 'J', 'K') | (turns ? 0 : letters('R'))) ||
         check_axis_users();
}

bool Interpreter::check_users(Letters of_motion) {
  const Block& block = *block_;
  for (const char letter : {'P', 'Q', 'R'}) {
    if (block.has(letter) &&
        users_of(codes_, letter) + ((of_motion & letter_bit(letter)) != 0 ? 1 : 0) > 1) {
      return fail(block.word(letter).offset, errors::kTwoUsersOfP,
                  joined({named(letter), " has two users in this block"}));
    }
  }
  return true;
}

bool Interpreter::check_ranges(Letters ranged) {
  const Block& block = *block_;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const bool is_angle = letter <= 'C';
    const double unit = is_angle ? 1.0 : mm_per_unit(state_.units);
    if ((ranged & letter_bit(letter)) != 0 && block.has(letter) &&
        !(std::fabs(block.value(letter)) * unit <= kLargestCoordinate_mm)) {
      return fail(
          block.word(letter).offset, errors::kParameterOutOfRange,
          joined({named(letter), ": value ", upper(block.text(block.word(letter)).substr(1, 40)),
                  " is outside -999999.999..999999.999"}));
    }
  }
  return true;
}

// Of D and H it is plain that they name an offset; programs carry them along where nothing takes
// them up, so they are no reason to stop.
void Interpreter::warn_idle_offset_numbers(Letters unused) {
  for (const char letter : {'D', 'H'}) {
    if ((unused & letter_bit(letter)) != 0) {
      const Word& word = block_->word(letter);
      if (letter == 'D' && dialect_ == Dialect::fanuc && !compensation_.on()) {
        state_.cutter_offset = word.value;
        continue;
      }
      warn(word.offset, errors::kIdleOffsetNumber,
           joined({upper(block_->text(word)), " is not used in this block (",
                   letter == 'D' ? "D needs G41 or G42)" : "H needs G43)"}));
    }
  }
}

bool Interpreter::check_axis_users() {
  if (dialect_ == Dialect::fanuc && codes_[Group::other] == kG53Machine) {
    return true;
  }
  const Tenths code = codes_[Group::motion];
  const bool moves = code == kNoCode ? state_.motion != Motion::none && codes_[Group::other] != kG4
                                     : code != kG80 && code != kG53 && code != kG63;
  return moves || explain_idle_axes();
}

bool Interpreter::explain_idle_axes() {
  const Word& word = *leftmost(*block_, axis_letters() | letters('I', 'J', 'K', 'R'));
  if (codes_.has(Group::motion)) {
    const std::string name = upper(block_->text(code_word(*block_, codes_, Group::motion)));
    return fail(word.offset, errors::kIdleAxisWords,
                joined({"axis words are given but ", name, " uses none"}));
  }
  if (codes_[Group::other] == kG4) {
    return fail(word.offset, errors::kDwellWithAxis,
                joined({"G4 takes the time in P, not in ", named(letter_of(*block_, word))}));
  }
  return fail(word.offset, errors::kNoMotionMode,
              "axis words are given but no motion mode is active (G0, G1, G2 ... is expected)");
}

bool Interpreter::explain_unused(const Word& word) {
  const char letter = letter_of(*block_, word);
  const std::string_view name = named(letter);
  switch (letter) {
    case 'A':
    case 'B':
    case 'C':
    case 'U':
    case 'V':
    case 'W':
      return fail(word.offset, errors::kUnknownAxis,
                  joined({"axis ", name, " does not exist on this machine"}));
    case 'E': {
      const char before = word.offset > 0 ? block_->line[word.offset - 1] : ' ';
      const std::string_view text = block_->text(word);
      const bool exponent = (before >= '0' && before <= '9') || before == '.';
      if (exponent && text.find('.') == std::string_view::npos) {
        return fail(word.offset, errors::kExponent,
                    "exponent notation is not allowed (E is an address letter)");
      }
      return fail(word.offset, errors::kExtruderWord,
                  "E is not used in this block (3D-printer file?)");
    }
    default:
      return fail(word.offset, errors::kUnusedWord, joined({name, " is not used in this block"}));
  }
}

}  // namespace kerf::parser
