#include "parser/compensation/compensation_codes.hpp"

#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/modal/end_point.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG41 = 410;
constexpr Tenths kG411 = 411;
constexpr Tenths kG421 = 421;

bool is_spline(Tenths code) {
  return code >= 50 && code <= 63;
}

// Motions that compensation can do: G0 to G3, and none.
bool is_plain(Tenths code) {
  return (code >= 0 && code <= 30) || code == static_cast<Tenths>(Motion::none);
}

CutterSide other(CutterSide side) {
  return side == CutterSide::left ? CutterSide::right : CutterSide::left;
}

std::string code_name(Tenths code) {
  return joined({"G", shortest(static_cast<double>(code) / 10.0)});
}

Done check_motion_while_compensating(const RunningBlock& at, const ModalState& state) {
  const bool moves = at.block.has_any(kAxisLetters | letters('I', 'J'));
  const Tenths code = at.codes.has(Group::motion) ? at.codes[Group::motion]
                      : moves                     ? static_cast<Tenths>(state.motion)
                                                  : static_cast<Tenths>(Motion::none);
  if (is_plain(code)) {
    return {};
  }
  if (is_spline(code)) {
    return fail(at.motion_offset(), errors::kCurveWhileCompensating,
                joined({code_name(code), " cannot be used while G41/G42 is active"}));
  }
  return fail(at.motion_offset(), errors::kCycleWhileCompensating,
              joined({code_name(code), " cannot be used while G41/G42 is active"}));
}

Done tip_of_l(const RunningBlock& at, const ModalState& state, CompensationStart& start) {
  if (!at.block.has('L')) {
    return {};
  }
  const Word& word = at.block.word('L');
  if (state.plane != Plane::zx) {
    return fail(word.offset, errors::kCompensationOrientationPlane,
                "L (orientation of a turning tool) can be used only in the XZ plane (G18)");
  }
  if (word.value != std::floor(word.value) || word.value < 0.0 || word.value > 9.0) {
    return fail(word.offset, errors::kCompensationOrientation,
                joined({"L (orientation of a turning tool) must be a whole number from 0 to 9, "
                        "found ",
                        shortest(word.value)}));
  }
  start.orientation = static_cast<int>(word.value);
  return {};
}

// G41 and G42: of the tool D. LinuxCNC takes the one in the spindle without D and with D0; with
// Fanuc D stays in force from an earlier block, and D0 is no offset.
Done radius_of_d(const RunningBlock& at, ModalState& state, const ToolTable& tools,
                 CompensationStart& start) {
  std::uint32_t offset = at.code_word(Group::cutter_compensation).offset;
  double number = at.rules.keeps_d ? state.cutter_offset : state.loaded_tool;
  if (at.block.has('D')) {
    offset = at.block.word('D').offset;
    const double d = at.block.value('D');
    number = d == 0.0 && !at.rules.zero_is_no_offset ? number : d;
  }
  if (number < 0.0) {
    return fail(offset, errors::kCompensationNegativeD, "D must not be negative");
  }
  if (number != std::floor(number)) {
    return fail(offset, errors::kCompensationDNotWhole,
                "D must be a whole number (of a tool; G41.1 and G42.1 take a diameter)");
  }
  state.cutter_offset = number;
  Expected<const Tool*> tool = named_tool(at, tools, number, offset);
  if (!tool) {
    tool.error()->page = &errors::kCompensationUnknownTool;
    return fault_of(tool);
  }
  const int orientation = (*tool)->orientation;
  start.radius_mm = (*tool)->diameter_mm / 2;
  start.orientation = orientation >= 0 && orientation <= 9 ? orientation : 0;
  return {};
}

// Negative for the other side of the contour.
Done set_radius(const RunningBlock& at, ModalState& state, const ToolTable& tools,
                CompensationStart& start) {
  const Tenths code = at.codes[Group::cutter_compensation];
  if (code != kG411 && code != kG421) {
    return radius_of_d(at, state, tools, start);
  }
  if (!at.block.has('D')) {
    return fail(at.code_word(Group::cutter_compensation).offset, errors::kCompensationWithoutD,
                joined({code_name(code), " needs D (the tool's diameter)"}));
  }
  const double diameter_mm = at.block.value('D') * mm_per_unit(state.units);
  if (!(std::fabs(diameter_mm) <= kLargestCoordinate_mm)) {
    const Word& word = at.block.word('D');
    return fail(word.offset, errors::kParameterOutOfRange,
                joined({"D: value ", upper(at.block.text(word).substr(1, 40)),
                        " is outside -999999.999..999999.999"}));
  }
  start.radius_mm = diameter_mm / 2;
  return tip_of_l(at, state, start);
}

}  // namespace

Done allowed_while_compensating(const RunningBlock& at, const ModalState& state) {
  const auto refuse = [&at](Group group) -> Done {
    const Word& word = at.code_word(group);
    return fail(word.offset, errors::kNotWhileCompensating,
                joined({upper(at.block.text(word)),
                        " cannot be used while cutter compensation is active: cancel with G40 "
                        "first"}));
  };
  if (at.codes.has(Group::tool)) {
    return refuse(Group::tool);
  }
  if (at.codes[Group::in_out] == 660) {  // M66: its contour is not known to its end
    return refuse(Group::in_out);
  }
  if (const Tenths code = at.codes[Group::plane]; code != kNoCode) {
    const Plane plane = plane_of(code);
    if (plane != state.plane) {
      return fail(at.code_word(Group::plane).offset, errors::kCompensationPlaneChange,
                  joined({"plane cannot change (", plane_name(state.plane), " to ",
                          plane_name(plane), ") while G41/G42 is active"}));
    }
  }
  if (at.codes[Group::cutter_compensation] == kG40) {
    return {};
  }
  for (const Group group :
       {Group::length_offset, Group::work_offset, Group::scaling, Group::mirror}) {
    if (at.codes.has(group)) {
      return refuse(group);
    }
  }
  if (at.codes.has(Group::local_offset) && state.coordinates.local_mm() != Point{}) {
    return refuse(Group::local_offset);
  }
  const Tenths other = at.codes[Group::other];
  const bool tool_data =
      other == 100 && at.block.has('L') && at.block.value('L') != 2 && at.block.value('L') != 20;
  if (other != kNoCode && other != 40 && !tool_data) {
    return refuse(Group::other);
  }
  return check_motion_while_compensating(at, state);
}

Expected<CompensationStart> read_compensation(const RunningBlock& at, ModalState& state,
                                              const ToolTable& tools, bool on) {
  const Word& word = at.code_word(Group::cutter_compensation);
  const std::string name = upper(at.block.text(word));
  const Tenths code = at.codes[Group::cutter_compensation];
  const CutterSide side = code == kG41 || code == kG411 ? CutterSide::left : CutterSide::right;
  if (on && at.rules.side_change_known && code != state.cutter_compensation) {
    return fail(word.offset, errors::kCompensationSideChange,
                joined({name, " while ", code_name(state.cutter_compensation),
                        " is active: a change of side is not supported, write G40 between them"}));
  }
  if (on) {
    return fail(word.offset, errors::kCompensationTwice,
                joined({name, " while ", code_name(state.cutter_compensation),
                        " is active: cancel with G40 first"}));
  }
  if (state.plane == Plane::yz) {
    return fail(word.offset, errors::kCompensationPlane,
                joined({name, " works in the planes XY (G17) and XZ (G18), not in YZ (G19)"}));
  }
  if (state.plane == Plane::zx && state.coordinates.turned()) {
    return fail(word.offset, errors::kCompensationTurned,
                joined({name,
                        " in the XZ plane cannot be used while the work offset is turned "
                        "(G10 L2 R)"}));
  }
  CompensationStart start;
  start.plane = state.plane;
  start.side = state.coordinates.mirrors(state.plane) ? other(side) : side;
  if (Done known = set_radius(at, state, tools, start); !known) {
    return fault_of(known);
  }
  if (start.radius_mm < 0.0) {
    start.radius_mm = -start.radius_mm;
    start.side = other(start.side);
    at.warn(word.offset, errors::kCompensationOtherSide,
            joined({name, ": the diameter is negative, the tool goes on the ",
                    start.side == CutterSide::left ? "left" : "right"}));
  }
  if (start.radius_mm == 0.0) {
    at.warn(word.offset, errors::kCompensationWithoutRadius,
            joined({name, ": the tool's diameter is 0, the path is run as programmed"}));
  }
  state.cutter_compensation = code;
  return start;
}

}  // namespace kerf::parser
