// G40, G41, G42, G41.1, G42.1, and what may not stand between them.
#include <cmath>

#include "diagnostics/errors/blocks.hpp"
#include "diagnostics/errors/compensation.hpp"
#include "parser/interpreter/interpreter.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG40 = 400;
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

}  // namespace

// What moves the coordinates, takes another tool or goes elsewhere must wait for G40, as with
// LinuxCNC. A G40 in the same block comes after the plane and M6 and before the rest.
bool Interpreter::allowed_while_compensating() {
  const auto refuse = [this](Group group) {
    const Word& word = code_word(*block_, codes_, group);
    return fail(word.offset, errors::kNotWhileCompensating,
                joined({upper(block_->text(word)),
                        " cannot be used while cutter compensation is active: cancel with G40 "
                        "first"}));
  };
  if (codes_.has(Group::tool)) {
    return refuse(Group::tool);
  }
  if (const Tenths code = codes_[Group::plane]; code != kNoCode) {
    const Plane plane = plane_of(code);
    if (plane != state_.plane) {
      return fail(code_word(*block_, codes_, Group::plane).offset, errors::kCompensationPlaneChange,
                  joined({"plane cannot change (", plane_name(state_.plane), " to ",
                          plane_name(plane), ") while G41/G42 is active"}));
    }
  }
  if (codes_[Group::cutter_compensation] == kG40) {
    return true;
  }
  for (const Group group :
       {Group::length_offset, Group::work_offset, Group::scaling, Group::mirror}) {
    if (codes_.has(group)) {
      return refuse(group);
    }
  }
  if (codes_.has(Group::local_offset) && state_.coordinates.local_mm() != Point{}) {
    return refuse(Group::local_offset);
  }
  const Tenths other = codes_[Group::other];
  const bool tool_data =
      other == 100 && block_->has('L') && block_->value('L') != 2 && block_->value('L') != 20;
  if (other != kNoCode && other != 40 && !tool_data) {
    return refuse(Group::other);
  }
  return check_motion_while_compensating();
}

bool Interpreter::check_motion_while_compensating() {
  const bool moves = block_->has_any(kAxisLetters | letters('I', 'J'));
  const Tenths code = codes_.has(Group::motion) ? codes_[Group::motion]
                      : moves                   ? static_cast<Tenths>(state_.motion)
                                                : static_cast<Tenths>(Motion::none);
  if (is_plain(code)) {
    return true;
  }
  if (is_spline(code)) {
    return fail(motion_offset(), errors::kCurveWhileCompensating,
                joined({code_name(code), " cannot be used while G41/G42 is active"}));
  }
  return fail(motion_offset(), errors::kCycleWhileCompensating,
              joined({code_name(code), " cannot be used while G41/G42 is active"}));
}

bool Interpreter::set_compensation() {
  if (codes_[Group::cutter_compensation] != kG40) {
    return start_compensation();
  }
  if (compensation_.on()) {
    compensation_.stop();
  }
  state_.cutter_compensation = kG40;
  return true;
}

bool Interpreter::start_compensation() {
  const Word& word = code_word(*block_, codes_, Group::cutter_compensation);
  const std::string name = upper(block_->text(word));
  const Tenths code = codes_[Group::cutter_compensation];
  const CutterSide side = code == kG41 || code == kG411 ? CutterSide::left : CutterSide::right;
  if (compensation_.on() && dialect_ == Dialect::fanuc && code != state_.cutter_compensation) {
    return fail(word.offset, errors::kCompensationSideChange,
                joined({name, " while ", code_name(state_.cutter_compensation),
                        " is active: a change of side is not supported, write G40 between them"}));
  }
  if (compensation_.on()) {
    return fail(word.offset, errors::kCompensationTwice,
                joined({name, " while ", code_name(state_.cutter_compensation),
                        " is active: cancel with G40 first"}));
  }
  if (state_.plane == Plane::yz) {
    return fail(word.offset, errors::kCompensationPlane,
                joined({name, " works in the planes XY (G17) and XZ (G18), not in YZ (G19)"}));
  }
  if (state_.plane == Plane::zx && state_.coordinates.turned()) {
    return fail(word.offset, errors::kCompensationTurned,
                joined({name,
                        " in the XZ plane cannot be used while the work offset is turned "
                        "(G10 L2 R)"}));
  }
  CompensationStart start;
  start.plane = state_.plane;
  start.side = state_.coordinates.mirrors(state_.plane) ? other(side) : side;
  if (!compensation_radius(start)) {
    return false;
  }
  if (start.radius_mm < 0.0) {
    start.radius_mm = -start.radius_mm;
    start.side = other(start.side);
    warn(word.offset, errors::kCompensationOtherSide,
         joined({name, ": the diameter is negative, the tool goes on the ",
                 start.side == CutterSide::left ? "left" : "right"}));
  }
  if (start.radius_mm == 0.0) {
    warn(word.offset, errors::kCompensationWithoutRadius,
         joined({name, ": the tool's diameter is 0, the path is run as programmed"}));
  }
  state_.cutter_compensation = code;
  compensation_.start(start);
  return true;
}

// Negative for the other side of the contour.
bool Interpreter::compensation_radius(CompensationStart& start) {
  const Tenths code = codes_[Group::cutter_compensation];
  if (code != kG411 && code != kG421) {
    return radius_of_d(start);
  }
  if (!block_->has('D')) {
    return fail(code_word(*block_, codes_, Group::cutter_compensation).offset,
                errors::kCompensationWithoutD,
                joined({code_name(code), " needs D (the tool's diameter)"}));
  }
  const double diameter_mm = block_->value('D') * mm_per_unit(state_.units);
  if (!(std::fabs(diameter_mm) <= kLargestCoordinate_mm)) {
    const Word& word = block_->word('D');
    return fail(word.offset, errors::kParameterOutOfRange,
                joined({"D: value ", upper(block_->text(word).substr(1, 40)),
                        " is outside -999999.999..999999.999"}));
  }
  start.radius_mm = diameter_mm / 2;
  return tip_of_l(start);
}

bool Interpreter::tip_of_l(CompensationStart& start) {
  if (!block_->has('L')) {
    return true;
  }
  const Word& word = block_->word('L');
  if (state_.plane != Plane::zx) {
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
  return true;
}

// G41 and G42: of the tool D. LinuxCNC takes the one in the spindle without D and with D0; with
// Fanuc D stays in force from an earlier block, and D0 is no offset.
bool Interpreter::radius_of_d(CompensationStart& start) {
  std::uint32_t offset = code_word(*block_, codes_, Group::cutter_compensation).offset;
  double number = dialect_ == Dialect::fanuc ? state_.cutter_offset : state_.loaded_tool;
  if (block_->has('D')) {
    offset = block_->word('D').offset;
    const double d = block_->value('D');
    number = d == 0.0 && dialect_ == Dialect::rs274 ? number : d;
  }
  if (number < 0.0) {
    return fail(offset, errors::kCompensationNegativeD, "D must not be negative");
  }
  if (number != std::floor(number)) {
    return fail(offset, errors::kCompensationDNotWhole,
                "D must be a whole number (of a tool; G41.1 and G42.1 take a diameter)");
  }
  state_.cutter_offset = number;
  const Tool* const tool = table_tool(number, offset);
  if (tool == nullptr) {
    fault_.page = &errors::kCompensationUnknownTool;
    return false;
  }
  start.radius_mm = tool->diameter_mm / 2;
  start.orientation = tool->orientation >= 0 && tool->orientation <= 9 ? tool->orientation : 0;
  return true;
}

// M72, or the return from a subprogram with M73, has brought modes back: the plane and the place of
// the coordinates must be what they were.
void Interpreter::keep_contour_in_place(const ModalState& before) {
  constexpr Point kOrigin{0.0, 0.0, 0.0};
  constexpr Point kElsewhere{1.0, 2.0, 3.0};
  const auto same_place = [&](const Point& point) {
    return state_.coordinates.to_machine(point) == before.coordinates.to_machine(point);
  };
  if (state_.plane == before.plane && same_place(kOrigin) && same_place(kElsewhere)) {
    return;
  }
  state_.plane = before.plane;
  state_.coordinates = before.coordinates;
  diagnostics_->add({line_, 1, file_}, errors::kNotWhileCompensating,
                    "the saved modes (M70, M73) have another plane or other offsets: they cannot "
                    "come back while cutter compensation is active");
}

// Takes what the block has put out through the compensation.
void Interpreter::compensate_moves() {
  Move move;
  while (!moves_.empty()) {
    moves_.pop(move);
    compensation_.take(move);
  }
  if (program_ended_) {
    compensation_.finish({line_, block_->first_word + 1, file_});
  }
  std::swap(moves_, compensation_.ready());
}

}  // namespace kerf::parser
