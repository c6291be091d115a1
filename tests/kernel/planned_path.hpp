// The path of a program's plan by itself: what ticks of the same program under commands are held
// against.
#pragma once

#include <string_view>
#include <vector>

#include <kerf/kernel.hpp>

#include "curves/curve.hpp"
#include "interp/setpoint.hpp"

namespace kerf::test {

class PlannedPath {
 public:
  // Precondition: the program has no errors and asks the machine nothing.
  PlannedPath(const MachineSettings& settings, const KernelOptions& options, std::string_view text);

  // How far the setpoint is from the place that the path has at the setpoint's path length.
  [[nodiscard]] double off_mm(const interp::Setpoint& setpoint) const;
  // By path length, at it; beyond the ends, theirs.
  [[nodiscard]] curves::PathDerivatives derivatives_at(double path_mm) const;

 private:
  struct Stretch {
    double curve_begin_mm = 0.0;  // path length
    curves::Piece piece;

    [[nodiscard]] double begin_mm() const { return curve_begin_mm + curves::s_begin_mm(piece); }
    // Of a path length, on the piece.
    [[nodiscard]] double on_piece_mm(double path_mm) const;
  };
  [[nodiscard]] const Stretch& stretch_at(double path_mm) const;

  std::vector<Stretch> stretches_;
};

}  // namespace kerf::test
