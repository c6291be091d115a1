#include "parser/curve_block.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parser/errors/curves.hpp"
#include "parser/errors/motion.hpp"
#include "parser/text.hpp"

namespace kerf::parser {

namespace {

constexpr Tenths kG53 = 530;

// Where coordinates are not those of the machine. Axes without a word keep their place to the last
// bit, unless the turn makes them move with another.
Point resolved_with_offsets(const CurveBlock& at, const Point& from_mm) {
  const Coordinates& coordinates = at.state.coordinates;
  const double unit = mm_per_unit(at.state.units);
  const bool incremental = at.state.incremental;
  Point program = incremental ? Point{} : coordinates.to_program(from_mm);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (at.block.has(axis_letter(axis))) {
      program[axis] = at.block.value(axis_letter(axis)) * unit;
    }
  }
  Point point =
      incremental ? coordinates.turned_to_machine(program) : coordinates.to_machine(program);
  const bool together = coordinates.turned() && at.block.has_any(letters('X', 'Y'));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool moves = at.block.has(axis_letter(axis)) || (together && axis < 2);
    if (!moves) {
      point[axis] = from_mm[axis];
    } else if (incremental) {
      point[axis] = sum_of_decimals(from_mm[axis], point[axis]);
    }
  }
  return point;
}

// In a turned coordinate system the word to blame may be that of the other axis.
Fault out_of_range(const Block& block, char letter) {
  const Word& word =
      block.has(letter) ? block.word(letter) : *leftmost(block, letters('X', 'Y', 'Z'));
  return {word.offset,
          joined({upper(block.text(word).substr(0, 1)), ": ", upper(block.text(word).substr(1, 40)),
                  " leads outside -999999.999..999999.999 mm"}),
          &errors::kPositionOutOfRange};
}

}  // namespace

double sum_of_decimals(double one, double other) {
  constexpr double kPlaces = 1e9;
  constexpr double kRounding = 2.0 * std::numeric_limits<double>::epsilon();
  const double sum = one + other;
  const double decimal = std::nearbyint(sum * kPlaces) / kPlaces;
  const double rounding = kRounding * std::max(std::fabs(one), std::fabs(other));
  return std::fabs(sum - decimal) <= rounding ? decimal : sum;
}

bool resolve_point(const CurveBlock& at, const Point& from_mm, Point& point, Fault& fault) {
  const bool plain = at.state.coordinates.plain() || at.codes[Group::other] == kG53;
  point = plain ? from_mm : resolved_with_offsets(at, from_mm);
  const double unit = mm_per_unit(at.state.units);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char letter = axis_letter(axis);
    const bool named = at.block.has(letter);
    if (plain && !named) {
      continue;
    }
    if (plain) {
      const double value = at.block.value(letter) * unit;
      point[axis] = at.state.incremental ? sum_of_decimals(from_mm[axis], value) : value;
    }
    if (!(std::fabs(point[axis]) <= kLargestCoordinate_mm)) {
      fault = out_of_range(at.block, letter);
      return false;
    }
  }
  return true;
}

const Word* leftmost(const Block& block, Letters set) {
  const Word* first = nullptr;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((set & letter_bit(letter)) != 0 && block.has(letter) &&
        (first == nullptr || block.word(letter).offset < first->offset)) {
      first = &block.word(letter);
    }
  }
  return first;
}

char letter_of(const Block& block, const Word& word) {
  return static_cast<char>(block.line[word.offset] & ~0x20);
}

void append_point(NurbsMove& curve, const NurbsPoint& point, std::uint32_t line) {
  curve.points.push_back(point);
  curve.point_lines.push_back(line);
}

bool CurveCode::fail(Fault& fault, std::uint32_t offset, const ErrorPage& page,
                     std::initializer_list<std::string_view> parts) const {
  fault = {offset, joined({name, ": ", joined(parts)}), &page};
  return false;
}

bool CurveCode::read_weight(const Block& block, const WeightRule& rule, double& weight,
                            Fault& fault) const {
  weight = block.value_or(rule.letter, 1.0);
  if (weight > 0.0) {
    return true;
  }
  return fail(fault, block.word(rule.letter).offset, *rule.page,
              {"weight ", std::string_view(&rule.letter, 1), " must be greater than 0, found ",
               shortest(weight)});
}

bool check_plane_axes(const CurveBlock& at, std::string_view name, Fault& fault) {
  const Plane plane = at.state.plane;
  const Letters wanted = plane_letters(plane);
  const Block& block = at.block;
  if (const Word* const foreign = leftmost(block, kAxisLetters & ~wanted)) {
    fault = {foreign->offset,
             joined({name, ": ", named(letter_of(block, *foreign)), " is not an axis of the ",
                     plane_name(plane), " plane"}),
             &errors::kCurveForeignAxis};
    return false;
  }
  if ((block.present & wanted) == wanted || !block.has_any(wanted)) {
    return true;
  }
  const PlaneAxes axes = axes_of(plane);
  const auto low = std::min(axes.first, axes.second);
  const auto high = std::max(axes.first, axes.second);
  fault = {leftmost(block, wanted)->offset,
           joined({name, ": ", named(axis_letter(low)), " and ", named(axis_letter(high)),
                   " must both be given"}),
           &errors::kCurveOneAxis};
  return false;
}

bool is_a_point(const NurbsMove& curve) {
  return std::all_of(curve.points.begin(), curve.points.end(), [&](const NurbsPoint& point) {
    return point.position_mm == curve.points.front().position_mm;
  });
}

}  // namespace kerf::parser
