// How far the path is from the straight line between two setpoints.
#pragma once

#include <array>
#include <cstddef>

#include "interp/motion.hpp"

namespace kerf::interp {

// A place on the path.
struct TickPlace {
  const CurvePiece& piece;
  double s_mm = 0.0;
  const Position& position_mm;
};

// begin() where the chord begins, pass() each piece that lies wholly between the two setpoints.
class TickChord {
 public:
  explicit TickChord(const Position& start_mm) noexcept : begin_mm_(start_mm) {}

  void begin(const TickPlace& place) noexcept {
    begin_mm_ = place.position_mm;
    s_begin_mm_ = place.s_mm;
    passed_points_ = 0;
    if (piece_.curve != place.piece.curve ||
        curves::s_begin_mm(piece_.geometry) != curves::s_begin_mm(place.piece.geometry)) {
      piece_ = place.piece;
    }
  }
  void pass(const CurvePiece& piece) noexcept;
  // The piece where it begins ends earlier than it did.
  void cut(const CurvePiece& piece) noexcept { piece_ = piece; }
  // The largest distance, taken at points of the path between the two, junctions included. If more
  // than kPassedPieces were passed, the later ones do not count.
  [[nodiscard]] double error_mm(const TickPlace& end) const noexcept;

 private:
  static constexpr std::size_t kPassedPieces = 16;
  static constexpr std::size_t kPoints = 4;  // of each piece, its end among them

  CurvePiece piece_{};
  Position begin_mm_;
  double s_begin_mm_ = 0.0;
  std::array<Position, kPassedPieces * kPoints> passed_mm_{};
  std::size_t passed_points_ = 0;
};

}  // namespace kerf::interp
