// A curve as points close to each other, from the definition alone: what ticks on singular curves
// are held against, where a search for the nearest point would lose its way.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "curves/nurbs_curve.hpp"
#include "interp/setpoint.hpp"
#include "tests/kernel/program_path.hpp"

namespace kerf::test {

struct PathPoint {
  Vec position_mm{};
  double s_mm = 0.0;  // along the points
};

// De Boor's points, so close that the lines between them miss no more of the curve than sag_mm.
std::vector<PathPoint> dense_path(const curves::NurbsData& data, double sag_mm);

// Judges each tick by the length that it says it has come: whether it is there on the curve, and
// how far the curve since the tick before leaves the straight line between the two.
class DenseChecker {
 public:
  // Keeps the path.
  DenseChecker(const std::vector<PathPoint>& path, double tolerance_mm)
      : path_(&path), tolerance_mm_(tolerance_mm) {}

  void add(const interp::Setpoint& setpoint);
  // What was exceeded, where and by how much; empty if nothing was.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  [[nodiscard]] double largest_mm() const { return largest_mm_; }

 private:
  void complain(const std::string& what, double found_mm, const interp::Setpoint& setpoint);

  const std::vector<PathPoint>* path_;
  double tolerance_mm_;
  std::size_t next_ = 0;  // the first point after the tick before
  Vec position_mm_{};
  bool begun_ = false;
  double largest_mm_ = 0.0;
  std::string complaint_;
};

}  // namespace kerf::test
