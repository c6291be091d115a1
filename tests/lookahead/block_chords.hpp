// Chord errors of ticks of planned motion over several blocks.
#pragma once

#include <algorithm>
#include <vector>

#include "tests/lookahead/motion.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {

inline Eigen::Vector3d point_at(const std::vector<Block>& blocks, double s_mm) {
  double s = s_mm;
  std::size_t i = 0;
  while (i + 1 < blocks.size() && s > blocks[i].length_mm) {
    s -= blocks[i++].length_mm;
  }
  return curves::vec(curves::position_at(blocks[i].curve, std::min(s, blocks[i].length_mm)));
}

inline double chord_error_mm(const std::vector<Block>& blocks, double from_mm, double way_mm) {
  const Eigen::Vector3d from = point_at(blocks, from_mm);
  const Eigen::Vector3d chord = point_at(blocks, from_mm + way_mm) - from;
  double worst = 0.0;
  for (int i = 1; i < 64; ++i) {
    const Eigen::Vector3d offset = point_at(blocks, from_mm + way_mm * i / 64.0) - from;
    const double along = std::clamp(offset.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    worst = std::max(worst, (offset - along * chord).norm());
  }
  return worst;
}

inline double worst_chord_error_mm(const std::vector<Block>& blocks, const Motion& motion) {
  double worst = 0.0;
  const int ticks = static_cast<int>(motion.duration_s() / kTs);
  for (int tick = 0; tick < ticks; ++tick) {
    const double from = motion.at(tick * kTs).s_mm;
    const double way = motion.at((tick + 1) * kTs).s_mm - from;
    worst = way > 0.0 ? std::max(worst, chord_error_mm(blocks, from, way)) : worst;
  }
  return worst;
}

}  // namespace kerf::lookahead::test
