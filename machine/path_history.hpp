// The recent commanded path, and how far a point is from it.
//
// The path is the polyline through the setpoints, which the axes follow: they run straight between
// two setpoints. It differs from the curve by the chord error of one tick,
// (v Ts)^2 / (8 rho), which the planner keeps below its chord tolerance; so does the distance.
//
// Lag is no contour error: an axis set that follows the path late, but on it, has distance 0.
// Therefore the distance is not taken to the newest setpoint but to the nearest point of the path
// before it. That point is within `lag` of the actual position, where lag is the distance to the
// newest setpoint, hence within 2 lag of the newest setpoint: the search goes back from it for 4
// lag of path length, which leaves room for the path to curl, and no farther, so that an old
// stretch that happens to pass near is not taken for the one being followed. Where the path curls
// more within the lag, or the history is too short, the answer is too large, never too small.
#pragma once

#include <array>
#include <cstddef>

#include "curves/position.hpp"

namespace kerf::machine {

class PathHistory {
 public:
  // Setpoints nearer to each other than this make no vertex of their own, so that slow motion and
  // dwells do not use up the history. The newest setpoint always counts.
  static constexpr double kVertexSpacingMm = 1e-4;
  static constexpr std::size_t kCapacity = 1024;

  void restart(const curves::Position& point_mm) noexcept;
  void append(const curves::Position& point_mm) noexcept;
  // At most kCapacity segments are searched.
  [[nodiscard]] double distance_mm(const curves::Position& actual_mm) const noexcept;

 private:
  struct Vertex {
    curves::Position point_mm{};
    double length_mm = 0.0;  // of the segment that ends here
  };

  [[nodiscard]] static std::size_t before(std::size_t index) noexcept {
    return (index + kCapacity - 1) % kCapacity;
  }

  std::array<Vertex, kCapacity> ring_{};
  std::size_t newest_ = 0;
  std::size_t count_ = 1;
};

}  // namespace kerf::machine
