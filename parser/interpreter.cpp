#include "parser/interpreter.hpp"

#include <algorithm>
#include <cmath>

#include "parser/cycles/drill_cycle.hpp"
#include "parser/errors/blocks.hpp"
#include "parser/errors/offsets.hpp"
#include "parser/lexical_error.hpp"
#include "parser/offsets/word_users.hpp"
#include "parser/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG4 = 40;
constexpr Tenths kG53 = 53;  // G5.3
constexpr Tenths kG53Machine = 530;
constexpr Tenths kG63 = 63;  // G6.3
constexpr Tenths kG64 = 640;
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

Interpreter::Interpreter(const Point& start_mm, DiagnosticList& diagnostics, MachineData machine,
                         Dialect dialect)
    : machine_(std::move(machine)),
      dialect_(dialect),
      diagnostics_(&diagnostics),
      compensation_(diagnostics),
      nurbs_(diagnostics) {
  state_.position_mm = start_mm;
  state_.to_initial_level = dialect == Dialect::fanuc;
  for (std::size_t system = 0; system < Coordinates::kSystems; ++system) {
    state_.coordinates.set_work(system, machine_.work[system]);
  }
}

bool Interpreter::fail(std::uint32_t offset, const ErrorPage& page, std::string message) {
  fault_ = {offset, std::move(message), &page};
  return false;
}

void Interpreter::report(const Fault& fault) {
  compensation_.forget_faults();
  if (reported_line_ != line_) {
    diagnostics_->add({line_, fault.offset + 1}, *fault.page, fault.message);
    reported_line_ = line_;
  }
}

void Interpreter::warn(std::uint32_t offset, const ErrorPage& page, std::string message) {
  diagnostics_->add({line_, offset + 1}, page, std::move(message));
}

Move& Interpreter::push_move() {
  Move& move = moves_.push();
  move.source = {line_, block_->first_word + 1, file_};
  move.start_mm = state_.position_mm;
  move.rapid = false;
  move.feedrate_mm_s = 0.0;
  move.mode = state_.path_mode;
  move.blend_tolerance_mm = state_.blend_tolerance_mm;
  return move;
}

void Interpreter::run(const Block& block, std::uint32_t line, bool complete) {
  block_ = &block;
  line_ = line;
  const bool sorted = sort_codes(block, dialect_, codes_, fault_);
  if (skipped_curve_ != kNoCode) {
    if (!sorted || !complete || !leave_skipped_curve()) {
      recover();
      return;
    }
  }
  if (!complete && (sorted || block.stop == Stop::too_many_g)) {
    fault_ = explain_stop(block);
  }
  if (!(sorted && complete && execute())) {
    report(fault_);
    if (curve_open()) {
      abandon_curve();
    } else {
      skip_curve_of_wrong_block();
    }
    recover();
  }
  if (compensation_.busy()) {
    compensate_moves();
  }
}

void Interpreter::end(std::uint32_t last_line, std::string_view where) {
  line_ = last_line;
  if (curve_open()) {
    report(nurbs_.active() ? nurbs_.unfinished(0, where) : uniform_.unfinished(0, where));
    abandon_curve();
  }
  if (compensation_.busy()) {
    compensation_.finish({last_line, 1, file_});
    compensate_moves();
  }
}

void Interpreter::end_program(SourcePosition source) {
  source.file = file_;
  Move& move = moves_.push();
  move = Move{EventMove{EventKind::program_end, 0.0}, source, state_.position_mm};
  program_ended_ = true;
}

bool Interpreter::execute() {
  if (compensation_.on() && !allowed_while_compensating()) {
    return false;
  }
  if (curve_open()) {
    if (!reports_open_curve()) {
      return continue_curve();
    }
    abandon_curve();
    skipped_curve_ = kNoCode;
  }
  if (begins_curve()) {
    return begin_curve();
  }
  if (!check_words()) {
    return false;
  }
  if (block_->g_count > 0) {
    set_units_and_feed_mode();
  }
  if ((block_->has_any(letters('F', 'S', 'T')) || codes_.has(Group::spindle_mode)) &&
      !(set_feed() && set_speed() && select_tool())) {
    return false;
  }
  if ((block_->m_count > 0 || block_->has('S')) && !switch_machine()) {
    return false;
  }
  if (block_->g_count > 0) {
    if (codes_[Group::other] == kG4 && !dwell()) {
      return false;
    }
    if (!set_modes()) {
      return false;
    }
  }
  if (!move()) {
    return false;
  }
  if (block_->m_count > 0) {
    stop();
  }
  return true;
}

// Every word of the block must have somebody who uses it.
bool Interpreter::check_words() {
  const Block& block = *block_;
  const Tenths code = codes_[Group::motion];
  const Motion motion = code == kNoCode ? state_.motion : static_cast<Motion>(code);
  const bool coded = block.g_count + block.m_count > 0;
  axis_taker_ = block.g_count > 0 ? taker_of_axes(block, codes_) : Group::count;
  const bool moves = axis_taker_ == Group::count &&
                     (code != kNoCode || block.has_any(kAxisLetters | letters('I', 'J', 'K', 'R')));
  const Letters of_motion = moves ? letters_of(motion, dialect_) : 0;
  const Letters usable = letters('N', 'F', 'S', 'T', 'O') | kAxisLetters | of_motion |
                         (coded ? letters_of_codes(codes_) : 0);
  if (Letters unused = block.present & ~usable; unused != 0) {
    warn_idle_offset_numbers(unused);
    unused &= ~letters('D', 'H');
    if (unused != 0) {
      return explain_unused(*leftmost(block, unused));
    }
  }
  if (block.has('N') && block.value('N') > kLargestLineNumber) {
    return fail(block.word('N').offset, errors::kLineNumberOutOfRange,
                joined({"N: line number ", upper(block.text(block.word('N')).substr(1, 40)),
                        " is out of range"}));
  }
  const bool taken = axis_taker_ != Group::count;
  const Letters ranged = letters('I', 'J', 'K', 'P', 'Q', 'R') | (taken ? kAxisLetters : 0);
  if (block.has_any(ranged) && !check_parameters(ranged, of_motion)) {
    return false;
  }
  if (taken) {
    return check_axis_taker(axis_taker_);
  }
  const bool turns = codes_[Group::spindle] == 190;  // M19 R
  return !block.has_any(kAxisLetters | letters('I', 'J', 'K') | (turns ? 0 : letters('R'))) ||
         check_axis_users();
}

// Words that somebody uses: no two may, and their values must be coordinates at most.
bool Interpreter::check_parameters(Letters ranged, Letters of_motion) {
  const Block& block = *block_;
  for (const char letter : {'P', 'Q', 'R'}) {
    if (block.has(letter) &&
        users_of(codes_, letter) + ((of_motion & letter_bit(letter)) != 0 ? 1 : 0) > 1) {
      return fail(block.word(letter).offset, errors::kTwoUsersOfP,
                  joined({named(letter), " has two users in this block"}));
    }
  }
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((ranged & letter_bit(letter)) != 0 && block.has(letter) &&
        !(std::fabs(block.value(letter)) * mm_per_unit(state_.units) <= kLargestCoordinate_mm)) {
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
  const Word& word = *leftmost(*block_, kAxisLetters | letters('I', 'J', 'K', 'R'));
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

// Takes over what can be told of a block with an error; see the class.
void Interpreter::recover() {
  const Block& block = *block_;
  for (std::size_t i = 0; i < block.g_count; ++i) {
    recover_code(block.g[i].value);
  }
  const CurveBlock here = curve_block();
  Point end;
  Fault ignored;
  if (block.has_any(kAxisLetters) && !is_cycle(state_.motion) &&
      taker_of_axes(block, codes_) == Group::count &&
      resolve_point(here, state_.position_mm, end, ignored)) {
    state_.position_mm = end;
  }
  if (block.has('F') && block.value('F') > 0.0 && state_.feed_mode == FeedMode::per_minute) {
    state_.feedrate_mm_s = feedrate_mm_s_from(block.value('F'), state_.units);
  }
}

void Interpreter::recover_code(double g) {
  const auto is = [g](double code) { return std::fabs(g - code) < 1e-9; };
  const auto tenths = static_cast<Tenths>(std::lround(std::clamp(g, 0.0, 99.0) * 10.0));
  if (is(0) || is(1) || is(2) || is(3) || is_cycle(static_cast<Motion>(tenths))) {
    set_motion(tenths);
  } else if (is(17) || is(18) || is(19)) {
    state_.plane = is(17) ? Plane::xy : is(18) ? Plane::zx : Plane::yz;
  } else if (is(20) || is(21)) {
    set_units(is(20) ? Units::inch : Units::mm);
  } else if (is(90) || is(91)) {
    state_.incremental = is(91);
  } else if (is(93) || is(94) || is(95)) {
    set_feed_mode(is(93)   ? FeedMode::inverse_time
                  : is(95) ? FeedMode::per_revolution
                           : FeedMode::per_minute);
  } else if (tenths >= 540 && tenths <= 593 && codes_[Group::work_offset] == tenths) {
    select_work_offset();
  } else if (is(80) && codes_[Group::motion] == kG80) {
    set_motion(kG80);
  } else if (is(40) && compensation_.on()) {
    compensation_.stop();
  }
}

}  // namespace kerf::parser
