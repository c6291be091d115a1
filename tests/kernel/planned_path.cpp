#include "tests/kernel/planned_path.hpp"

#include <algorithm>
#include <cstdint>

#include "curves/position.hpp"
#include "kernel/pipeline.hpp"

namespace kerf::test {

using curves::vec;

PlannedPath::PlannedPath(const MachineSettings& settings, const KernelOptions& options,
                         std::string_view text) {
  Pipeline pipeline({.settings = settings, .options = options});
  pipeline.feed(text);
  pipeline.finish();
  std::uint64_t curve = 0;
  double begin_mm = 0.0;
  double end_mm = 0.0;
  for (lookahead::Outbox outbox; pipeline.step(outbox) != Pipeline::Step::ended; outbox.clear()) {
    for (const interp::CurvePiece& piece : outbox.pieces) {
      if (piece.extra.alone) {
        continue;
      }
      if (piece.curve != curve) {
        begin_mm = end_mm;
        curve = piece.curve;
      }
      stretches_.push_back({.curve_begin_mm = begin_mm, .piece = piece.geometry});
      end_mm = begin_mm + curves::s_end_mm(piece.geometry);
    }
  }
}

double PlannedPath::Stretch::on_piece_mm(double path_mm) const {
  return std::clamp(path_mm - curve_begin_mm, curves::s_begin_mm(piece), curves::s_end_mm(piece));
}

const PlannedPath::Stretch& PlannedPath::stretch_at(double path_mm) const {
  const auto after = std::ranges::upper_bound(stretches_, path_mm, {}, &Stretch::begin_mm);
  return after == stretches_.begin() ? *after : *(after - 1);
}

double PlannedPath::off_mm(const interp::Setpoint& setpoint) const {
  const Stretch& at = stretch_at(setpoint.s_mm);
  const curves::Position place = curves::position_at(at.piece, at.on_piece_mm(setpoint.s_mm));
  return (vec(place) - vec(setpoint.position_mm)).norm();
}

curves::PathDerivatives PlannedPath::derivatives_at(double path_mm) const {
  const Stretch& at = stretch_at(path_mm);
  return curves::derivatives_at(at.piece, at.on_piece_mm(path_mm));
}

}  // namespace kerf::test
