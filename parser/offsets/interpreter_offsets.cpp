// Where coordinates lie: G54 to G59.3, G43, G28 and G30.
#include <cmath>

#include "diagnostics/errors/cycles.hpp"
#include "diagnostics/errors/offsets.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/modal/word_users.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG10 = 100;
constexpr Tenths kG28 = 280;
constexpr Tenths kStoreG28 = 281;
constexpr Tenths kG30 = 300;
constexpr Tenths kStoreG30 = 301;
constexpr Tenths kG52 = 520;
constexpr Tenths kG92 = 920;

}  // namespace

// G10, G28, G30, G52 and G92 take the axis words; beside a motion code they would be in doubt. Of a
// rapid it is plain what it means: `G0 G91 G28 Z0` is usual with Fanuc.
bool Interpreter::check_axis_taker(Group taker) {
  if (!codes_.has(Group::motion) || codes_[Group::motion] == 800 ||
      !block_->has_any(axis_letters())) {
    return true;
  }
  const Tenths code = codes_[taker];
  if (codes_[Group::motion] == 0 && (code == kG28 || code == kG30)) {
    return true;
  }
  const Word& motion = code_word(*block_, codes_, Group::motion);
  return fail(motion.offset, errors::kTwoAxisUsers,
              joined({upper(block_->text(code_word(*block_, codes_, taker))), " and ",
                      upper(block_->text(motion)), " both use the axis words"}));
}

bool Interpreter::select_work_offset() {
  const Tenths code = codes_[Group::work_offset];
  if (code == kNoCode) {
    return true;
  }
  if (code == 541) {
    return select_extended_offset();
  }
  const int system = code > 590 ? 5 + code % 10 : (code - 540) / 10;
  state_.coordinates.select(static_cast<std::size_t>(system));
  return true;
}

// The axis words in mm; 0 for an axis without one.
Point Interpreter::axis_words_mm() const {
  const double unit = mm_per_unit(state_.units);
  return {block_->value_or('X', 0.0) * unit, block_->value_or('Y', 0.0) * unit,
          block_->value_or('Z', 0.0) * unit};
}

bool Interpreter::needs_axis_words() {
  if (block_->has_any(axis_letters())) {
    return true;
  }
  const Group taker = taker_of_axes(*block_, codes_);
  const Word& code = code_word(*block_, codes_, taker);
  return fail(code.offset, errors::kAxisWordMissing,
              joined({upper(block_->text(code)), " needs at least one axis word"}));
}

// The codes that do something once, in place of the block's motion.
bool Interpreter::do_once() {
  switch (codes_[Group::other]) {
    case kG10:
      return set_data();
    case kG28:
      return go_home({machine_.first_home_mm, machine_.first_home_extra_deg_mm});
    case kG30: {
      const auto home = reference_point();
      return home && go_home(*home);
    }
    case kStoreG28:
      machine_.first_home_mm = state_.position_mm;
      machine_.first_home_extra_deg_mm = state_.extra_deg_mm;
      break;
    case kStoreG30:
      machine_.second_home_mm = state_.position_mm;
      machine_.second_home_extra_deg_mm = state_.extra_deg_mm;
      break;
    case kG52:
    case kG92:
      return set_local_offset();
    default:
      break;
  }
  return true;
}

void Interpreter::push_rapid(const Point& end_mm, const ExtraWords& extra_deg_mm) {
  if (end_mm == state_.position_mm && extra_deg_mm == state_.extra_deg_mm) {
    return;
  }
  Move& move = push_move();
  move.shape = LineMove{end_mm};
  move.rapid = true;
  carry_extra(move, extra_deg_mm);
  state_.position_mm = end_mm;
}

// By way of the point that the axis words name; then only the axes that have a word go home, or
// all where none has.
bool Interpreter::go_home(const HomePosition& home) {
  if (is_cycle(state_.motion)) {
    const Word& code = code_word(*block_, codes_, Group::other);
    return fail(code.offset, errors::kHomeInCycle,
                joined({upper(block_->text(code)),
                        " while a canned cycle is active: cancel with G80 first"}));
  }
  if (!block_->has_any(axis_letters())) {
    push_rapid(home.mm, home.extra_deg_mm);
    return true;
  }
  Point via;
  ExtraWords extra_via;
  if (!resolve_point(curve_block(), state_.position_mm, via, fault_) || !resolve_extra(extra_via)) {
    return false;
  }
  push_rapid(via, extra_via);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    via[axis] = block_->has(axis_letter(axis)) ? home.mm[axis] : via[axis];
  }
  for (std::size_t axis = 0; axis < kExtraAxes; ++axis) {
    extra_via[axis] = block_->has(kExtraNames[axis]) ? home.extra_deg_mm[axis] : extra_via[axis];
  }
  push_rapid(via, extra_via);
  return true;
}

bool Interpreter::set_length_offset() {
  const Tenths code = codes_[Group::length_offset];
  if (code == kNoCode) {
    return true;
  }
  state_.tool_length_active = code != 490;
  if (code == 490) {
    state_.coordinates.set_tool({});
    return true;
  }
  if (code == 430 || code == 440 || (code == 432 && block_->has('H'))) {
    return code == 432 ? add_length_offset() : set_length_from_table();
  }
  if (!needs_axis_words() || !refuse_extra("with G43.1 and G43.2")) {
    return false;
  }
  const Point words = axis_words_mm();
  Point tool = state_.coordinates.tool_mm();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block_->has(axis_letter(axis))) {
      tool[axis] = words[axis] + (code == 432 ? tool[axis] : 0.0);
    }
  }
  state_.coordinates.set_tool(tool);
  return true;
}

bool Interpreter::set_length_from_table() {
  const Tool* const tool = tool_of_h();
  if (tool == nullptr) {
    return false;
  }
  const bool negative = codes_[Group::length_offset] == 440;  // Fanuc's G44
  const Point& offset = tool->offset_mm;
  state_.coordinates.set_tool(negative ? Point{-offset[0], -offset[1], -offset[2]} : offset);
  return true;
}

bool Interpreter::add_length_offset() {
  const Tool* const tool = tool_of_h();
  if (tool == nullptr) {
    return false;
  }
  Point sum = state_.coordinates.tool_mm();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum[axis] += tool->offset_mm[axis];
  }
  state_.coordinates.set_tool(sum);
  return true;
}

// The tool whose number H gives. LinuxCNC takes the one in the spindle where there is no H or H0;
// with Fanuc H0 is no offset. Null: the fault is set.
const Tool* Interpreter::tool_of_h() {
  const Word& code = code_word(*block_, codes_, Group::length_offset);
  if (!block_->has('H') || (block_->value('H') == 0.0 && dialect_ == Dialect::rs274)) {
    return table_tool(state_.loaded_tool, code.offset);
  }
  const Word& word = block_->word('H');
  if (word.value < 0.0) {
    fail(word.offset, errors::kNegativeOffsetNumber, "H must not be negative");
    return nullptr;
  }
  if (word.value != std::floor(word.value)) {
    fail(word.offset, errors::kOffsetNumberNotWhole, "H must be a whole number");
    return nullptr;
  }
  return table_tool(word.value, word.offset);
}

// The tool of that number; null, with the fault, where the table has none. The message names the
// word at `offset` as the program has it.
const Tool* Interpreter::table_tool(double number, std::uint32_t offset) {
  constexpr double kMost = ToolTable::kHighestNumber;
  const Tool* const tool = number <= kMost ? machine_.tools.find(static_cast<std::int32_t>(number))
                           : machine_.tools.given() ? nullptr
                                                    : machine_.tools.find(0);
  if (tool == nullptr) {
    const char letter = static_cast<char>(block_->line[offset] & ~0x20);
    const bool named_here = letter == 'T' || letter == 'H' || letter == 'D' || letter == 'P';
    fail(offset, errors::kToolNotInTable,
         joined({named(named_here && letter != 'P' ? letter : 'T'), shortest(number),
                 " is not in the tool table"}));
  }
  return tool;
}

}  // namespace kerf::parser
