#include "parser/interpreter/arc_words.hpp"

#include <algorithm>
#include <cmath>

#include "diagnostics/errors/pages.hpp"
#include "parser/moves/auxiliary_axes.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kHalfCircleTolerance_mm = 0.01;
constexpr double kRadiusTolerance_mm = 0.0283;
constexpr double kRadiusTolerance = 0.001;
constexpr double kLargestRadiusDifference_mm = 2.83;

bool radii_agree(double at_start, double at_end) {
  const double difference = std::fabs(at_start - at_end);
  return difference <= kRadiusTolerance_mm ||
         (difference <= kLargestRadiusDifference_mm &&
          difference <= kRadiusTolerance * std::max(at_start, at_end));
}

// I, J and K as a place on the machine, absolute or from where the tool is.
Point centre_in_machine(const BlockWords& block, const ModalState& state, bool absolute) {
  const double unit = mm_per_unit(state.units);
  Point words{block.value_or('I', 0.0) * unit, block.value_or('J', 0.0) * unit,
              block.value_or('K', 0.0) * unit};
  if (!state.coordinates.plain()) {
    words =
        absolute ? state.coordinates.to_machine(words) : state.coordinates.turned_to_machine(words);
  }
  const Point& from = state.position_mm;
  return absolute ? words : Point{from[0] + words[0], from[1] + words[1], from[2] + words[2]};
}

Done turns_from(const BlockWords& block, ArcMove& arc) {
  constexpr double kMaxTurns = 1e6;
  if (!block.has('P')) {
    arc.turns = 1;
    return {};
  }
  const Word& word = block.word('P');
  if (word.value != std::floor(word.value)) {
    return fail(word.offset, errors::kTurnsNotWhole, "P (turns of an arc) must be a whole number");
  }
  if (word.value < 1.0 || word.value > kMaxTurns) {
    return fail(word.offset, errors::kTurnsOutOfRange,
                joined({"P (turns of an arc) must be 1 or more, found ", shortest(word.value)}));
  }
  arc.turns = static_cast<int>(word.value);
  return {};
}

Done centre_from_radius(const BlockWords& block, const ModalState& state, ArcMove& arc) {
  const PlaneAxes axes = axes_of(arc.plane);
  const Word& word = block.word('R');
  const double scale = std::fabs(state.coordinates.scaling().factor[axes.first]);
  const double radius = word.value * mm_per_unit(state.units) * scale;
  const InPlane start = in_plane(state.position_mm, axes);
  const InPlane end = in_plane(arc.end_mm, axes);
  const double chord = distance(start, end);
  if (radius == 0.0) {
    return fail(word.offset, errors::kZeroRadius, "R must not be 0");
  }
  if (!block.has_any(letter_bit(axis_letter(axes.first)) | letter_bit(axis_letter(axes.second)))) {
    return fail(word.offset, errors::kRadiusWithoutEnd, "an arc given by R needs an end point");
  }
  // The centre may be anywhere around a chord that is an effect of rounding.
  if (chord <= kShortestWay_mm) {
    return fail(word.offset, errors::kRadiusFullCircle,
                "an arc given by R cannot be a full circle: the end point is the start point");
  }
  const double size = std::fabs(radius);
  if (size < chord / 2 - kHalfCircleTolerance_mm) {
    return fail(word.offset, errors::kRadiusTooSmall,
                joined({"R", shortest(word.value), " is too small: the end point is ", in_mm(chord),
                        " mm away, a radius of at least ", in_mm(chord / 2), " mm is needed"}));
  }
  // Square root of r^2 - (chord/2)^2 without cancellation.
  const double height = std::sqrt(std::max(0.0, (size - chord / 2) * (size + chord / 2)));
  const double left = (arc.clockwise == (radius > 0.0)) ? -height : height;
  arc.centre_mm[axes.first] =
      (start.first + end.first) / 2 - left * (end.second - start.second) / chord;
  arc.centre_mm[axes.second] =
      (start.second + end.second) / 2 + left * (end.first - start.first) / chord;
  return {};
}

std::string radii_differ(InPlane start, InPlane end, InPlane centre) {
  const double at_start = distance(centre, start);
  const double at_end = distance(centre, end);
  return joined({"the arc's radius differs by ", in_mm(std::fabs(at_start - at_end)),
                 " mm between start (", in_mm(at_start), ") and end (", in_mm(at_end), ")"});
}

Done check_radii(const BlockWords& block, const ModalState& state, const ArcMove& arc) {
  const PlaneAxes axes = axes_of(arc.plane);
  const InPlane start = in_plane(state.position_mm, axes);
  const InPlane end = in_plane(arc.end_mm, axes);
  const InPlane centre = in_plane(arc.centre_mm, axes);
  const char first = centre_letter(axes.first);
  const char second = centre_letter(axes.second);
  const Word& word = block.word(block.has(first) ? first : second);
  // An offset that is lost beside the start makes an arc that is too short to be one, not a fault.
  const bool offset_is_lost =
      !state.absolute_centre && ((block.has(first) && block.value(first) != 0.0) ||
                                 (block.has(second) && block.value(second) != 0.0));
  if (distance(centre, start) == 0.0 && !offset_is_lost) {
    return fail(word.offset, errors::kCentreIsStart,
                "the arc's centre is its start point (radius 0)");
  }
  if (radii_agree(distance(centre, start), distance(centre, end))) {
    return {};
  }
  const InPlane as_absolute = in_plane(centre_in_machine(block, state, true), axes);
  std::string message = radii_differ(start, end, centre);
  if (!state.absolute_centre &&
      radii_agree(distance(as_absolute, start), distance(as_absolute, end))) {
    message += " (is the centre meant absolute? G91.1 is active)";
  }
  return fail(word.offset, errors::kRadiiDiffer, std::move(message));
}

Done centre_from_words(const BlockWords& block, const ModalState& state, ArcMove& arc) {
  const PlaneAxes axes = axes_of(arc.plane);
  const char first = centre_letter(axes.first);
  const char second = centre_letter(axes.second);
  if (state.absolute_centre && !(block.has(first) && block.has(second))) {
    const Word& word = block.word(block.has(first) ? first : second);
    return fail(word.offset, errors::kAbsoluteCentreIncomplete,
                joined({"G90.1 is active: ", named(std::min(first, second)), " and ",
                        named(std::max(first, second)), " must both be given"}));
  }
  const Point centre = centre_in_machine(block, state, state.absolute_centre);
  for (const std::size_t axis : {axes.first, axes.second}) {
    arc.centre_mm[axis] = centre[axis];
  }
  return check_radii(block, state, arc);
}

Done check_centre_words(const BlockWords& block, Plane plane) {
  const PlaneAxes axes = axes_of(plane);
  const Letters centre =
      letter_bit(centre_letter(axes.first)) | letter_bit(centre_letter(axes.second));
  const char normal = centre_letter(axes.normal);
  if (block.has(normal)) {
    return fail(
        block.word(normal).offset, errors::kCentreOutsidePlane,
        joined({named(normal), " is not used by an arc in the ", plane_name(plane), " plane"}));
  }
  if (block.has('R') && block.has_any(centre)) {
    return fail(block.word('R').offset, errors::kRadiusAndCentre, "R and a centre are both given");
  }
  return {};
}

// The end of an arc that is its start but for the rounding of offsets, turns and G91 is its start:
// the arc is a whole turn, no way of some 1e-16 mm.
void close_circle(const Point& start_mm, ArcMove& arc) {
  constexpr double kLargestAngle_rad = 1e-6;
  const PlaneAxes axes = axes_of(arc.plane);
  const InPlane start = in_plane(start_mm, axes);
  const double chord_mm = distance(start, in_plane(arc.end_mm, axes));
  const double radius_mm = distance(start, in_plane(arc.centre_mm, axes));
  if (chord_mm <= std::min(kShortestWay_mm, kLargestAngle_rad * radius_mm)) {
    arc.end_mm[axes.first] = start_mm[axes.first];
    arc.end_mm[axes.second] = start_mm[axes.second];
  }
}

}  // namespace

Expected<ArcMove> build_arc(const BlockWords& block, const ModalState& state, const Point& end_mm) {
  ArcMove arc;
  arc.plane = state.plane;
  arc.clockwise = (state.motion == Motion::arc_clockwise) != state.coordinates.mirrors(state.plane);
  arc.centre_mm = state.position_mm;
  arc.end_mm = end_mm;
  Done done = check_centre_words(block, arc.plane)
                  .and_then([&] { return turns_from(block, arc); })
                  .and_then([&] {
                    return block.has('R') ? centre_from_radius(block, state, arc)
                                          : centre_from_words(block, state, arc);
                  });
  if (!done) {
    return fault_of(done);
  }
  if (!block.has('R')) {
    close_circle(state.position_mm, arc);
  }
  return arc;
}

}  // namespace kerf::parser
