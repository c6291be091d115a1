// From the words of G2 and G3 to centre and turns.
#pragma once

#include <array>
#include <string_view>

#include "parser/block.hpp"
#include "parser/fault.hpp"
#include "parser/modal_state.hpp"
#include "parser/move.hpp"

namespace kerf::parser {

// Indices into a Point of the plane's axes in right-handed order.
struct PlaneAxes {
  std::size_t first;
  std::size_t second;
  std::size_t normal;
};
constexpr PlaneAxes axes_of(Plane plane) {
  switch (plane) {
    case Plane::zx:
      return {2, 0, 1};
    case Plane::yz:
      return {1, 2, 0};
    default:
      return {0, 1, 2};
  }
}
constexpr char axis_letter(std::size_t axis) {
  return static_cast<char>('X' + axis);
}
constexpr char centre_letter(std::size_t axis) {
  return static_cast<char>('I' + axis);
}

std::string_view plane_name(Plane plane);  // XY, XZ, YZ

// The arc that the block describes, from state.position_mm to `end_mm`, as RS274/NGC reads it
// (NISTIR 6556, 3.5.3). In the radius form a radius up to 0.01 mm shorter than half the chord is
// taken as a half circle. In the centre form the radii at the start and at the end may differ by
// 0.0283 mm, or by 0.1 % up to 2.83 mm, which are LinuxCNC's limits. False: `fault` says why.
// Precondition: the block has no word that an arc cannot use.
bool build_arc(const Block& block, const ModalState& state, const Point& end_mm, ArcMove& arc,
               Fault& fault);

// Along the arc or helix, with the mean of both radii where they differ.
double arc_length_mm(const ArcMove& arc, const Point& start_mm);
// Of those at the start and at the end.
double larger_radius_mm(const ArcMove& arc, const Point& start_mm);

}  // namespace kerf::parser
