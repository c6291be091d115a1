// Fanuc's system variables, as far as they make sense on a mill.
#include <array>

#include "parser/offsets/machine_values.hpp"

namespace kerf::parser {

namespace {

constexpr int kAlarm = 3000;
constexpr int kMessage = 3006;

// Three axes that begin after `first`; 3 where the number is none of them.
std::size_t axis_behind(int first, int number) {
  return number > first && number <= first + 3 ? static_cast<std::size_t>(number - first - 1) : 3;
}

// The work offset and its axis after a number: #5221 is X of G54 and 20 further on is G55; #7001
// is X of G54.1 P1, up to P48, and #14001 too, up to P300.
struct WorkPlace {
  std::size_t system = 0;
  std::size_t axis = 3;

  [[nodiscard]] bool exists() const { return axis < 3; }
};
WorkPlace work_place(int number) {
  struct Range {
    int before_first;
    int systems;
    std::size_t first_system;
  };
  constexpr std::array kRanges{Range{5220, 6, 0}, Range{7000, 48, Coordinates::kSystems},
                               Range{14000, 300, Coordinates::kSystems}};
  constexpr int kApart = 20;
  for (const Range& range : kRanges) {
    const int behind = number - range.before_first - 1;
    if (behind >= 0 && behind < range.systems * kApart && behind % kApart < 3) {
      return {range.first_system + static_cast<std::size_t>(behind / kApart),
              static_cast<std::size_t>(behind % kApart)};
    }
  }
  return {};
}

// Offsets of tools: length (#2001 and #11001 on) and radius (#13001 on); wear is always 0.
enum class ToolField : std::uint8_t { none, length, radius, wear };
struct ToolPlace {
  ToolField field = ToolField::none;
  std::int32_t tool = 0;
};
ToolPlace tool_place(int number) {
  constexpr int kOffsets = 400;
  const auto in = [number](int first, int count) {
    return number > first && number <= first + count;
  };
  if (in(2000, 200)) {
    return {ToolField::length, number - 2000};
  }
  if (in(11000, kOffsets)) {
    return {ToolField::length, number - 11000};
  }
  if (in(13000, kOffsets)) {
    return {ToolField::radius, number - 13000};
  }
  if (in(10000, kOffsets) || in(12000, kOffsets)) {
    return {ToolField::wear, number % 1000};
  }
  return {};
}

double tool_offset_mm(const ToolTable& tools, const ToolPlace& place) {
  const Tool* const tool = tools.find(place.tool);
  if (tool == nullptr || place.field == ToolField::wear) {
    return 0.0;
  }
  return place.field == ToolField::length ? tool->offset_mm[2] : tool->diameter_mm / 2;
}

double plane_code(Plane plane) {
  return plane == Plane::xy ? 17.0 : plane == Plane::zx ? 18.0 : 19.0;
}

double work_code(std::size_t system) {
  if (system >= Coordinates::kSystems) {
    return 54.1;
  }
  return system < 6 ? 54.0 + static_cast<double>(system) : 59.0;
}

double feed_code(FeedMode mode) {
  return mode == FeedMode::inverse_time ? 93.0 : mode == FeedMode::per_minute ? 94.0 : 95.0;
}

// The codes and words in force: #4001 and on by group, #4109 and on by letter.
std::optional<double> modal_value(int number, const ModalState& state) {
  switch (number) {
    case 4001:
      return static_cast<double>(state.motion) / 10.0;
    case 4002:
      return plane_code(state.plane);
    case 4003:
      return state.incremental ? 91.0 : 90.0;
    case 4005:
      return feed_code(state.feed_mode);
    case 4006:
      return state.units == Units::inch ? 20.0 : 21.0;
    case 4008:
      return state.tool_length_active ? 43.0 : 49.0;
    case 4011:
      return state.coordinates.scaling() == Scaling{} ? 50.0 : 51.0;
    case 4014:
      return work_code(state.coordinates.system());
    case 4016:
      return state.coordinates.program_turn() == ProgramTurn{} ? 69.0 : 68.0;
    case 4109:
      return state.feed_word;
    case 4119:
      return state.spindle_speed;
    case 4120:
      return state.tool;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<double> MachineValues::fanuc_number(int number) const {
  if (number == kAlarm || number == kMessage) {
    return 0.0;
  }
  const ModalState& state = memory_->state;
  const double unit = mm_per_unit(state.units);
  if (const WorkPlace place = work_place(number); place.exists()) {
    return state.coordinates.work(place.system).origin_mm[place.axis] / unit;
  }
  if (const ToolPlace place = tool_place(number); place.field != ToolField::none) {
    return tool_offset_mm(memory_->machine.tools, place) / unit;
  }
  for (const int first : {5000, 5040}) {  // where the block before ended; where the tool is
    if (const std::size_t axis = axis_behind(first, number); axis < 3) {
      return state.coordinates.to_program(state.position_mm)[axis] / unit;
    }
  }
  if (const std::size_t axis = axis_behind(5020, number); axis < 3) {
    return state.position_mm[axis] / unit;
  }
  if (const std::size_t axis = axis_behind(5060, number); axis < 3) {
    return state.probe.position_mm[axis] / unit;
  }
  if (const std::size_t axis = axis_behind(5080, number); axis < 3) {
    return state.coordinates.tool_mm()[axis] / unit;
  }
  if (axis_behind(5200, number) < 3) {
    return 0.0;  // the external work offset
  }
  return modal_value(number, state);
}

bool MachineValues::fanuc_take(int number, double value) {
  ModalState& state = memory_->state;
  if (number == kAlarm || number == kMessage) {
    using Kind = MacroSignal::Kind;
    state.signal = {.kind = number == kAlarm ? Kind::alarm : Kind::stop, .number = value};
    return true;
  }
  const double unit = mm_per_unit(state.units);
  if (const WorkPlace place = work_place(number); place.exists()) {
    WorkOffset offset = state.coordinates.work(place.system);
    offset.origin_mm[place.axis] = value * unit;
    state.coordinates.set_work(place.system, offset);
    return true;
  }
  const ToolPlace place = tool_place(number);
  if (place.field != ToolField::length && place.field != ToolField::radius) {
    return false;
  }
  const Tool* const listed = memory_->machine.tools.find(place.tool);
  if (listed == nullptr) {
    return false;
  }
  Tool tool = *listed;
  tool.number = place.tool;
  if (place.field == ToolField::length) {
    tool.offset_mm[2] = value * unit;
  } else {
    tool.diameter_mm = 2.0 * value * unit;
  }
  memory_->machine.tools.put(tool);
  return true;
}

}  // namespace kerf::parser
