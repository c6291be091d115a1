#include "interp/tick_chord.hpp"

#include <algorithm>
#include <variant>

namespace kerf::interp {

using curves::vec;

namespace {

double distance_to_chord_mm(const Position& point, const Position& from,
                            const Position& to) noexcept {
  const Eigen::Vector3d chord = vec(to) - vec(from);
  const Eigen::Vector3d offset = vec(point) - vec(from);
  const double squared = chord.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(offset.dot(chord) / squared, 0.0, 1.0) : 0.0;
  return (offset - share * chord).norm();
}

}  // namespace

void TickChord::pass(const CurvePiece& piece) noexcept {
  if (passed_points_ == passed_mm_.size()) {
    return;
  }
  const double begin = curves::s_begin_mm(piece.geometry);
  const double length = curves::s_end_mm(piece.geometry) - begin;
  for (std::size_t k = 1; k <= kPoints; ++k) {
    const double share = static_cast<double>(k) / kPoints;
    passed_mm_[passed_points_++] = curves::position_at(piece.geometry, begin + share * length);
  }
}

// The second setpoint itself is not looked at.
double TickChord::error_mm(const TickPlace& end) const noexcept {
  const bool junction = end.piece.curve != piece_.curve && piece_.curve != 0;
  if (!junction && passed_points_ == 0 &&
      std::holds_alternative<curves::Line>(end.piece.geometry)) {
    return 0.0;
  }
  double error = 0.0;
  const auto look_at = [&](const Position& point) {
    error = std::max(error, distance_to_chord_mm(point, begin_mm_, end.position_mm));
  };
  const auto look = [&](const CurvePiece& piece, double s_mm) {
    look_at(curves::position_at(piece.geometry, s_mm));
  };
  const double s_junction = curves::s_end_mm(piece_.geometry);
  if (junction) {
    look(piece_, s_junction);
  }
  for (std::size_t k = 1; k < kPoints; ++k) {
    const double share = static_cast<double>(k) / kPoints;
    if (junction) {
      look(piece_, s_begin_mm_ + share * (s_junction - s_begin_mm_));
      look(end.piece, share * end.s_mm);
      continue;
    }
    const double s = s_begin_mm_ + share * (end.s_mm - s_begin_mm_);
    if (piece_.curve != 0 && s <= s_junction) {
      look(piece_, s);
    } else if (s >= curves::s_begin_mm(end.piece.geometry)) {
      look(end.piece, s);
    }
  }
  std::for_each_n(passed_mm_.begin(), passed_points_, look_at);
  return error;
}

}  // namespace kerf::interp
