// A look at a whole program before anything moves: text, curves and soft limits.
#pragma once

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

/// What a check found.
struct KERF_API CheckReport {
  std::vector<Diagnostic> diagnostics;   ///< of the text and of curves that cannot be built
  std::vector<Diagnostic> limit_faults;  ///< paths that leave the travel, one for each block
  Extents extents{};                     ///< of all motion, with the bulge of arcs and splines
  AuxiliaryExtents extra_extents{};      ///< of A, B, C, U, V, W
  bool moves = false;                    ///< false: extents mean nothing

  [[nodiscard]] bool has_errors() const;
};

/// Gives the next bytes of the program; empty at its end.
using TextSource = std::function<std::string_view()>;

/// Asked before each move; true ends the check early.
using StopRequest = std::function<bool()>;

/// Where a check ends though the program goes on: it may loop for ever.
struct CheckBounds {
  StopRequest stop{};
  /// An error once the program must have run for longer, for the length of its moves alone
  /// (LeastTime). A program that passes may still take longer.
  double max_time_s = kUnbounded;
};

KERF_API CheckReport check_program(const TextSource& text, const MachineSettings& settings,
                                   const KernelOptions& options = {},
                                   const CheckBounds& bounds = {});

}  // namespace v0
}  // namespace kerf
