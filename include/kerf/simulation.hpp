// What stands around the simulated table: what its probe touches, its inputs, its switches and its
// spindle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <kerf/api.hpp>
#include <kerf/axes.hpp>
#include <kerf/setpoint.hpp>
#include <tl/expected.hpp>

namespace kerf {
inline namespace v0 {

/// A block with faces along the axes, in machine coordinates; without bounds in some directions it
/// is a table (z_max alone) or a wall.
struct TouchBox {
  static constexpr double kFar_mm = kUnbounded;

  Position min_mm{-kFar_mm, -kFar_mm, -kFar_mm};
  Position max_mm{kFar_mm, kFar_mm, kFar_mm};  ///< no component below that of min_mm
};

/// What lies behind a plane, seen against its normal.
struct TouchPlane {
  Position point_mm{};
  Position normal{0.0, 0.0, 1.0};  ///< of any length above 0
};

struct TouchSphere {
  Position centre_mm{};
  double radius_mm = 1.0;  ///< > 0
};

/// What lies below heights over a grid along X and Y, bilinear between its points; beside the grid
/// there is nothing.
struct HeightMap {
  static constexpr std::size_t kMaxColumns = 1000;  ///< and rows

  std::array<double, 2> origin_mm{};           ///< x and y of the first point
  std::array<double, 2> spacing_mm{1.0, 1.0};  ///< > 0
  std::size_t columns = 0;                     ///< along X, >= 2
  std::vector<double> heights_mm{};            ///< z, row by row along X; two rows or more
};

/// In machine coordinates. The tip of the tool in the spindle touches it: its offset in the tool
/// table as the program finds it. It is the one that `shape` says; the others do not count.
struct TouchSurface {
  enum class Shape : std::uint8_t { box, plane, sphere, height_map };

  TouchSurface() = default;
  TouchSurface(const TouchBox& from) : box{from} {}
  TouchSurface(const TouchPlane& from) : shape{Shape::plane}, plane{from} {}
  TouchSurface(const TouchSphere& from) : shape{Shape::sphere}, sphere{from} {}
  TouchSurface(HeightMap from) : shape{Shape::height_map}, height_map{std::move(from)} {}

  Shape shape = Shape::box;
  TouchBox box{};
  TouchPlane plane{};
  TouchSphere sphere{};
  HeightMap height_map{};
};

/// What is wrong with the text of a height map.
struct HeightMapError {
  std::uint32_t line = 0;  ///< 1-based
  std::string_view message{};
};

/// Reads lines of "x y z" in mm, in machine coordinates, which make a grid in any order: all pairs
/// of some x and some y, both evenly spaced. Blank lines and what follows a '#' say nothing; a
/// comma parts numbers as a blank does.
//
/// Errors: a line of other than three finite numbers, no grid, a spacing that is not even, fewer
/// than two columns or rows or more than kMaxColumns.
KERF_API tl::expected<HeightMap, HeightMapError> read_height_map(std::string_view text);

/// Where an axis closes its switches, in machine coordinates. An infinite place is never reached.
struct AxisSwitches {
  double home_min_mm = kUnbounded;      ///< closed from here
  double home_max_mm = kUnbounded;      ///< to here
  double lower_limit_mm = -kUnbounded;  ///< closed here and below
  double upper_limit_mm = kUnbounded;   ///< closed here and above
};

struct SimulationSettings {
  std::optional<TouchSurface> surface{};  ///< nothing: G38 touches nothing
  bool latches_probe = false;  ///< the place of a contact is known to be between two ticks
  std::array<AxisSwitches, 3> switches{};
  std::uint64_t digital = 0;  ///< inputs that are high: bit n is input n
  std::array<double, Outputs::kAnalog> analog{};
  double spindle_rad_s2 = 0.0;  ///< how fast it gains and loses speed, >= 0; 0: at once
};

}  // namespace v0
}  // namespace kerf
