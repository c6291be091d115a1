#include "parser/interpreter/words.hpp"

#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/cycles/drill_cycle.hpp"
#include "parser/dialects/fanuc/fanuc_codes.hpp"
#include "parser/modal/end_point.hpp"
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

constexpr Tenths kG28 = 280;
constexpr Tenths kG30 = 300;

// Who takes the axis words: a code (Group::count: none), or the motion with its letters.
struct AxisUse {
  Group taker = Group::count;
  Letters of_motion = 0;
};

// Letters that the motion takes beside the axes.
Letters letters_of(Motion motion, const DialectRules& rules) {
  switch (motion) {
    case Motion::arc_clockwise:
    case Motion::arc_counterclockwise:
      return letters('I', 'J', 'K', 'R', 'P');
    case Motion::cubic_spline:
      return letters('I', 'J', 'P', 'Q');
    case Motion::quadratic_spline:
      return letters('I', 'J', 'Q');
    default:
      return is_cycle(motion) ? letters_of_cycle(motion, rules) : 0;
  }
}

// What is inline here is a part of check_words(): a call for each block would be felt.
[[gnu::always_inline]] inline Letters usable_letters(const RunningBlock& at, Letters of_motion) {
  const Letters always = letters('N', 'F', 'S', 'T', 'O') | at.axis_letters() | of_motion;
  if (at.block.g_count + at.block.m_count == 0) {
    return always;
  }
  return always | letters_of_codes(at.codes) | (at.rules.control_codes ? letters_of_fanuc(at) : 0);
}

Done check_users(const RunningBlock& at, Letters of_motion) {
  const BlockWords& block = at.block;
  for (const char letter : {'P', 'Q', 'R'}) {
    if (block.has(letter) &&
        users_of(at.codes, letter) + ((of_motion & letter_bit(letter)) != 0 ? 1 : 0) > 1) {
      return fail(block.word(letter).offset, errors::kTwoUsersOfP,
                  joined({named(letter), " has two users in this block"}));
    }
  }
  return {};
}

Done check_ranges(const RunningBlock& at, Units units, Letters ranged) {
  const BlockWords& block = at.block;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    const bool is_angle = letter <= 'C';
    const double unit = is_angle ? 1.0 : mm_per_unit(units);
    if ((ranged & letter_bit(letter)) != 0 && block.has(letter) &&
        !(std::fabs(block.value(letter)) * unit <= kLargestCoordinate_mm)) {
      return fail(
          block.word(letter).offset, errors::kParameterOutOfRange,
          joined({named(letter), ": value ", upper(block.text(block.word(letter)).substr(1, 40)),
                  " is outside -999999.999..999999.999"}));
    }
  }
  return {};
}

// Words that somebody uses: no two may, and their values must be coordinates at most.
struct UsedLetters {
  Letters of_motion = 0;
  Letters ranged = 0;
};
[[gnu::noinline]] Done check_parameters(const RunningBlock& at, Units units,
                                        const UsedLetters& used) {
  return check_users(at, used.of_motion).and_then([&] {
    return check_ranges(at, units, used.ranged);
  });
}

[[gnu::cold]] diagnostics::Failure refuse_line_number(const RunningBlock& at) {
  const Word& word = at.block.word('N');
  return fail(
      word.offset, errors::kLineNumberOutOfRange,
      joined({"N: line number ", upper(at.block.text(word).substr(1, 40)), " is out of range"}));
}

bool has_axis_user(const RunningBlock& at, Motion in_force) {
  if (at.rules.machine_rapid && at.codes[Group::other] == kG53Machine) {
    return true;
  }
  const Tenths code = at.codes[Group::motion];
  return code == kNoCode ? in_force != Motion::none && at.codes[Group::other] != kG4
                         : code != kG80 && code != kG53 && code != kG63;
}

// Of D and H it is plain that they name an offset; programs carry them along where nothing takes
// them up, so they are no reason to stop.
[[gnu::cold]] void take_idle_offset_numbers(const RunningBlock& at, ModalState& state,
                                            Letters unused, bool compensating) {
  for (const char letter : {'D', 'H'}) {
    if ((unused & letter_bit(letter)) != 0) {
      const Word& word = at.block.word(letter);
      if (letter == 'D' && at.rules.keeps_d && !compensating) {
        state.cutter_offset = word.value;
        continue;
      }
      at.warn(word.offset, errors::kIdleOffsetNumber,
              joined({upper(at.block.text(word)), " is not used in this block (",
                      letter == 'D' ? "D needs G41 or G42)" : "H needs G43)"}));
    }
  }
}

// Both would take the axis words.
Done fail_of_two(const RunningBlock& at, Group taker, Group other) {
  const Word& second = at.code_word(other);
  return fail(second.offset, errors::kTwoAxisUsers,
              joined({upper(at.block.text(at.code_word(taker))), " and ",
                      upper(at.block.text(second)), " both use the axis words"}));
}

// G10, G28, G30, G52 and G92 take the axis words; beside a motion code or G43.1 they would be in
// doubt. Of a rapid it is plain what it means: `G0 G91 G28 Z0` is usual with Fanuc.
[[gnu::cold]] Done check_axis_taker(const RunningBlock& at, Group taker) {
  if (!at.block.has_any(at.axis_letters())) {
    return {};
  }
  if (taker != Group::length_offset && offset_takes_axes(at.block, at.codes)) {
    return fail_of_two(at, taker, Group::length_offset);
  }
  if (!at.codes.has(Group::motion) || at.codes[Group::motion] == 800) {
    return {};
  }
  const Tenths code = at.codes[taker];
  if (at.codes[Group::motion] == 0 && (code == kG28 || code == kG30)) {
    return {};
  }
  return fail_of_two(at, taker, Group::motion);
}

[[gnu::cold]] Done explain_idle_axes(const RunningBlock& at) {
  const Word& word = *leftmost(at.block, at.axis_letters() | letters('I', 'J', 'K', 'R'));
  if (at.codes.has(Group::motion)) {
    const std::string name = at.name_of(Group::motion);
    return fail(word.offset, errors::kIdleAxisWords,
                joined({"axis words are given but ", name, " uses none"}));
  }
  if (at.codes[Group::other] == kG4) {
    return fail(word.offset, errors::kDwellWithAxis,
                joined({"G4 takes the time in P, not in ", named(letter_of(at.block, word))}));
  }
  return fail(word.offset, errors::kNoMotionMode,
              "axis words are given but no motion mode is active (G0, G1, G2 ... is expected)");
}

[[gnu::cold]] Done explain_unused(const RunningBlock& at, const Word& word) {
  const char letter = letter_of(at.block, word);
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
      const char before = word.offset > 0 ? at.block.line[word.offset - 1] : ' ';
      const std::string_view text = at.block.text(word);
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

// Who takes the axis words, and what the motion takes.
AxisUse axis_use_of(const RunningBlock& at, Motion in_force) {
  const BlockWords& block = at.block;
  const Tenths code = at.codes[Group::motion];
  const Motion motion = code == kNoCode ? in_force : static_cast<Motion>(code);
  AxisUse use{block.g_count > 0 ? taker_of_axes(block, at.codes) : Group::count};
  if (at.codes[Group::other] == kG4 && at.rules.dwell_in_axes) {
    use.taker = Group::other;  // X is a time
  }
  const bool moves =
      use.taker == Group::count &&
      (code != kNoCode || block.has_any(at.axis_letters() | letters('I', 'J', 'K', 'R')));
  use.of_motion = moves ? letters_of(motion, at.rules) : 0;
  return use;
}

// Of axis words one is the taker, or a motion.
Done check_axis_words(const RunningBlock& at, Group taker, Motion in_force) {
  if (taker != Group::count) {
    return check_axis_taker(at, taker);
  }
  const Letters turns = at.codes[Group::spindle] == 190 ? letters('R') : 0;  // M19 R
  const Letters moving = (at.axis_letters() | letters('I', 'J', 'K', 'R')) & ~turns;
  return at.block.has_any(moving) && !has_axis_user(at, in_force) ? explain_idle_axes(at) : Done{};
}

}  // namespace

Expected<Group> check_words(const RunningBlock& at, ModalState& state, bool compensating) {
  const BlockWords& block = at.block;
  const AxisUse use = axis_use_of(at, state.motion);
  if (Letters unused = block.present & ~usable_letters(at, use.of_motion); unused != 0) {
    take_idle_offset_numbers(at, state, unused, compensating);
    unused &= ~letters('D', 'H');
    if (unused != 0) {
      Done wrong = explain_unused(at, *leftmost(block, unused));
      return fault_of(wrong);
    }
  }
  if (block.has('N') && block.value('N') > kLargestLineNumber) {
    return refuse_line_number(at);
  }
  const bool taken = use.taker != Group::count;
  const Letters ranged = letters('I', 'J', 'K', 'P', 'Q', 'R') | (taken ? at.axis_letters() : 0);
  if (block.has_any(ranged)) {
    if (Done fine = check_parameters(at, state.units, {use.of_motion, ranged}); !fine) {
      return fault_of(fine);
    }
  }
  if (Done fine = check_axis_words(at, use.taker, state.motion); !fine) {
    return fault_of(fine);
  }
  return use.taker;
}

}  // namespace kerf::parser
