// Checks a whole program before anything moves: text, curves and soft limits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include <kerf/api.hpp>
#include <kerf/axes.hpp>
#include <kerf/diagnostic.hpp>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

namespace kerf {
inline namespace v0 {

/// What motion fills of one axis.
struct AxisRange {
  double min_mm = kUnbounded;
  double max_mm = -kUnbounded;

  /// Nothing moves there.
  [[nodiscard]] bool is_empty() const { return max_mm < min_mm; }
};

/// The motion of a program in the coordinates that its text has: of the work offset in force, with
/// G52, G92 and the tool's offset.
struct WorkExtents {
  /// Of the systems in which there is motion: 0 is G54 ... 8 is G59.3, then G54.1 P1 and on.
  std::vector<std::size_t> systems;
  Extents all{};
  Extents cutting{};     ///< of what is no rapid; means nothing without CheckReport::cuts
  bool is_known = true;  ///< false: axes are turned, scaled or mirrored somewhere
};

/// Which part of the motion of X, Y and Z follows which work offset. The rest stays where it is on
/// the machine: G53, G28, the start.
struct OffsetExtents {
  std::array<std::array<AxisRange, 3>, kWorkSystems> following{};
  std::array<AxisRange, 3> fixed{};
  std::array<bool, 3> is_known{true, true, true};  ///< false: that axis' offsets do more than that
};

/// The result of a check.
struct KERF_API CheckReport {
  /// Of the text and of curves that cannot be built. After 100 errors the reading ends.
  std::vector<Diagnostic> diagnostics;
  /// Moves that leave the travel: one for each block, at most 100, up to the first error.
  std::vector<Diagnostic> limit_faults;
  Extents extents{};                 ///< of all motion, with the bulge of arcs and splines
  AuxiliaryExtents extra_extents{};  ///< of A, B, C, U, V, W
  bool moves = false;                ///< false: extents mean nothing
  Extents cutting_extents{};         ///< of what is no rapid
  bool cuts = false;                 ///< false: cutting_extents mean nothing
  WorkExtents work_extents{};
  OffsetExtents offset_extents{};
  bool in_inches = false;  ///< G20 was in force at the first motion
  NominalTime nominal{};   ///< what KernelOptions::nominal wants
  double length_mm = 0.0;  ///< of all moves as they are programmed; where only A, B, C turn, in rad

  /// There is an error in `diagnostics`. limit_faults do not count: look at both.
  [[nodiscard]] bool has_errors() const;
};

/// Gives the next bytes of the program; empty at its end. The view must stay valid until the next
/// call.
using TextSource = std::function<std::string_view()>;

/// Asked before each step; true ends the check early. The report then covers what was read so far.
using StopRequest = std::function<bool()>;

/// Where a check ends although the program goes on, for it may loop for ever; and what the start
/// is.
struct CheckBounds {
  StopRequest stop{};
  /// In s. The check ends with an error when the length of the moves alone, at the highest
  /// feedrates allowed, takes longer. A program that passes may still take longer.
  double max_time_s = kUnbounded;
  /// How many moves, those of a loop as often as they run. More are an error.
  std::uint64_t max_moves = UINT64_MAX;
  /// The start is where the first moves lead, and elsewhere where these lead elsewhere: so
  /// CheckReport::offset_extents count no way to it.
  bool starts_at_first_places = false;
};

/// Reads the program to its end and plans nothing. Impossible settings are an error in the report,
/// but limits may be missing. Throws std::bad_alloc only, and what the callbacks throw.
KERF_API CheckReport check_program(const TextSource& text, const MachineSettings& settings,
                                   const KernelOptions& options = {},
                                   const CheckBounds& bounds = {});

/// The same of the text alone: its curves are not built, so neither their faults nor those of the
/// travel are found, and there are no extents. Many times faster.
KERF_API CheckReport check_syntax(const TextSource& text, const MachineSettings& settings,
                                  const KernelOptions& options = {},
                                  const CheckBounds& bounds = {});

}  // namespace v0
}  // namespace kerf
