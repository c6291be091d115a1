// A drawn path of any length in bounded memory.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "programs/kerf/plot/projection.hpp"

namespace kerf::program {

struct OutlinePoint {
  PaperPoint at{};
  double v_mm_s = 0.0;
  bool rapid = false;
  bool hidden = false;  // the line to here is hidden
};

// Of what is cut; where nothing is, of all. Precondition: not empty.
[[nodiscard]] PaperBox box_around(const std::vector<OutlinePoint>& points);

// The colour of the line to a point; kColourLevels: it is a rapid. point > 0.
[[nodiscard]] std::size_t level_to(std::size_t point, const std::vector<OutlinePoint>& outline,
                                   double max_v_mm_s);

// How far the outline may differ from the path.
struct OutlineTolerance {
  double distance_mm = 0.0;
  double v_share = 1.0 / 64.0;  // of the largest feedrate so far that is no rapid's
};

// Points go in one by one; one is kept where the straight line from the last kept point would leave
// the tolerance, the feedrate has changed by more than its own, or a rapid begins or ends. The
// feedrate of rapids does not matter. When the kept points run out, lines go that lie under others
// of the same colour or a slower one, which are drawn on top: so no feedrate is mixed with that of
// its neighbours. Only where that is not enough, the distance doubles and the outline is thinned by
// the same rule; feedrates that are more than a colour apart are never joined.
//
// The rule is a sleeve: the directions from the last kept point that pass every point since within
// the tolerance form a sector, which only narrows. A point outside the sector ends the stretch. The
// cost of a point is constant; the result is at most some tens of percent longer than the best one.
class PathOutline {
 public:
  explicit PathOutline(const OutlineTolerance& tolerance, std::size_t max_points = 100'000);

  void add(const OutlinePoint& point);

  // How wide the lines are to be drawn at the least, so that they cover those that are hidden.
  [[nodiscard]] double line_width_mm() const noexcept;

  // The kept points and the last one.
  [[nodiscard]] std::vector<OutlinePoint> points() const;

 private:
  // Directions as angles about that of the first point of the stretch.
  struct Sector {
    double axis_rad = 0.0;
    double low_rad = 0.0;
    double high_rad = 0.0;
  };

  // False: the stretch ends before the point.
  bool extend_stretch(const OutlinePoint& point);
  void append(const OutlinePoint& point);
  void keep(const OutlinePoint& point);
  void drop_hidden();
  void thin();

  OutlineTolerance tolerance_;
  double coarsest_share_;
  std::size_t max_points_;
  double max_v_mm_s_ = 0.0;
  std::vector<OutlinePoint> kept_;
  std::optional<OutlinePoint> last_;  // the newest point, unless it is kept
  std::optional<Sector> sector_;      // none: no point of this stretch is off the kept one
  double farthest_mm_ = 0.0;
};

}  // namespace kerf::program
