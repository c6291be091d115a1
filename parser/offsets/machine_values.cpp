#include "parser/offsets/machine_values.hpp"

namespace kerf::parser {

namespace {

constexpr int kProbe = 5061;
constexpr int kProbeSuccess = 5070;
constexpr int kFirstHome = 5161;
constexpr int kSecondHome = 5181;
constexpr int kLocalActive = 5210;
constexpr int kLocal = 5211;
constexpr int kSystem = 5220;
constexpr int kWork = 5221;
constexpr int kWorkEnd = kWork + 20 * static_cast<int>(Coordinates::kSystems - 1) + 10;
constexpr int kInput = 5399;
constexpr int kTool = 5400;
constexpr int kToolEnd = 5414;
constexpr int kPosition = 5420;
constexpr int kAxes = 9;  // X Y Z A B C U V W

// The axis of parameter `number` in the nine that begin at `first`; kAxes where it is not in them.
int axis_in(int number, int first) {
  return number >= first && number < first + kAxes ? number - first : kAxes;
}

// Axes that the machine does not have are at 0.
double coordinate(const Point& point, const AuxiliaryWords& auxiliary, int axis) {
  return axis < 3 ? point[static_cast<std::size_t>(axis)]
                  : auxiliary[static_cast<std::size_t>(axis - 3)];
}

// Angles do not change with the unit of lengths.
double unit_of(int axis, double mm_per_unit) {
  return axis < 3 || !is_rotary(static_cast<std::size_t>(axis - 3)) ? mm_per_unit : 1.0;
}

// Which number of which system: 20 to a system, X to W and then R.
struct WorkNumber {
  std::size_t system;
  int axis;
};
WorkNumber work_number(int number) {
  return {static_cast<std::size_t>((number - kWork) / 20), (number - kWork) % 20};
}

constexpr int kRotation = 9;

struct AxisValue {
  int axis = 0;
  double value = 0.0;
};

// False: there is no such axis, or the machine does not have it.
bool put(const AxisValue& given, Letters extra_axes, Point& point, AuxiliaryWords& auxiliary) {
  if (given.axis >= kAxes) {
    return false;
  }
  if (given.axis < 3) {
    point[static_cast<std::size_t>(given.axis)] = given.value;
    return true;
  }
  const auto k = static_cast<std::size_t>(given.axis - 3);
  const bool named = (extra_axes & letter_bit(kAuxiliaryNames[k])) != 0;
  auxiliary[k] = named ? given.value : auxiliary[k];
  return named;
}

}  // namespace

std::optional<double> MachineValues::number(int number) const {
  if (rules_of(memory_->dialect).control_variables) {
    return fanuc_number(number);
  }
  const ModalState& state = memory_->state;
  const double unit = mm_per_unit(state.units);
  if (const int axis = axis_in(number, kProbe); axis < kAxes) {
    return coordinate(state.probe.position_mm, state.probe.auxiliary_deg_mm, axis) /
           unit_of(axis, unit);
  }
  if (const int axis = axis_in(number, kFirstHome); axis < kAxes) {
    return coordinate(memory_->machine.first_home_mm, memory_->machine.first_home_extra_deg_mm,
                      axis);
  }
  if (const int axis = axis_in(number, kSecondHome); axis < kAxes) {
    return coordinate(memory_->machine.second_home_mm, memory_->machine.second_home_extra_deg_mm,
                      axis);
  }
  if (const int axis = axis_in(number, kLocal); axis < kAxes) {
    return coordinate(state.stored_local_mm, state.stored_local_auxiliary_deg_mm, axis);
  }
  if (const int axis = axis_in(number, kPosition); axis < kAxes) {
    return coordinate(state.coordinates.to_program(state.position_mm),
                      state.coordinates.auxiliary_to_program(state.auxiliary_deg_mm), axis) /
           unit_of(axis, unit);
  }
  if (number >= kTool && number < kToolEnd) {
    return tool_value(number);
  }
  if (number >= kWork && number < kWorkEnd) {
    return work_value(number);
  }
  switch (number) {
    case kProbeSuccess:
      return state.probe.touched ? 1.0 : 0.0;
    case kLocalActive:
      return state.local_active ? 1.0 : 0.0;
    case kSystem:
      return static_cast<double>(state.coordinates.system() + 1);
    case kInput:
      return state.input;
    default:
      return std::nullopt;
  }
}

std::optional<double> MachineValues::tool_value(int number) const {
  const Tool* const listed = memory_->machine.tools.find(memory_->state.loaded_tool);
  const Tool tool = listed != nullptr ? *listed : Tool{};
  switch (number - kTool) {
    case 0:
      return static_cast<double>(memory_->state.loaded_tool);
    case 10:
      return tool.diameter_mm;
    case 11:
      return tool.front_angle_deg;
    case 12:
      return tool.back_angle_deg;
    case 13:
      return static_cast<double>(tool.orientation);
    default:
      return coordinate(tool.offset_mm, {}, number - kTool - 1);
  }
}

std::optional<double> MachineValues::work_value(int number) const {
  const WorkNumber which = work_number(number);
  const WorkOffset& offset = memory_->state.coordinates.work(which.system);
  if (which.axis > kRotation) {
    return std::nullopt;
  }
  return which.axis == kRotation ? offset.rotation_deg
                                 : coordinate(offset.origin_mm, offset.extra_deg_mm, which.axis);
}

bool MachineValues::take(int number, double value) {
  if (rules_of(memory_->dialect).control_variables) {
    return fanuc_take(number, value);
  }
  ModalState& state = memory_->state;
  const auto take_axis = [&](Point& point, AuxiliaryWords& auxiliary, int axis) {
    return put({axis, value}, memory_->machine.extra_axes, point, auxiliary);
  };
  if (const int axis = axis_in(number, kFirstHome); axis < kAxes) {
    return take_axis(memory_->machine.first_home_mm, memory_->machine.first_home_extra_deg_mm,
                     axis);
  }
  if (const int axis = axis_in(number, kSecondHome); axis < kAxes) {
    return take_axis(memory_->machine.second_home_mm, memory_->machine.second_home_extra_deg_mm,
                     axis);
  }
  if (const int axis = axis_in(number, kLocal); axis < kAxes) {
    return take_axis(state.stored_local_mm, state.stored_local_auxiliary_deg_mm, axis);
  }
  if (const int axis = axis_in(number, kProbe); axis < kAxes) {
    return take_axis(state.probe.position_mm, state.probe.auxiliary_deg_mm, axis);
  }
  if (number == kInput) {
    state.input = value;
    return true;
  }
  if (number < kWork || number >= kWorkEnd) {
    return false;
  }
  const WorkNumber which = work_number(number);
  WorkOffset offset = state.coordinates.work(which.system);
  if (which.axis == kRotation) {
    offset.rotation_deg = value;
  } else if (!take_axis(offset.origin_mm, offset.extra_deg_mm, which.axis)) {
    return false;
  }
  state.coordinates.store_work(which.system, offset);
  return true;
}

}  // namespace kerf::parser
