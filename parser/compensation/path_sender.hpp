// From ways in the plane back to moves.
#pragma once

#include "parser/compensation/held_move.hpp"
#include "parser/moves/arc_geometry.hpp"
#include "parser/moves/move_queue.hpp"

namespace kerf::parser {

class PathSender {
 public:
  // `shift_mm` goes from the tool's centre to the controlled point.
  void set_frame(Plane plane, planar::Vec shift_mm) {
    plane_ = plane;
    axes_ = axes_of(plane);
    shift_mm_ = shift_mm;
  }
  // Where the machine is after all moves sent so far.
  void set_place(const Point& place_mm) { place_mm_ = place_mm; }
  [[nodiscard]] const Point& place_mm() const { return place_mm_; }
  [[nodiscard]] planar::Vec centre_mm() const { return in_plane(place_mm_) - shift_mm_; }
  [[nodiscard]] planar::Vec in_plane(const Point& point) const {
    return {point[axes_.first], point[axes_.second]};
  }
  [[nodiscard]] planar::Vec centre_for(const Point& place_mm) const {
    return in_plane(place_mm) - shift_mm_;
  }

  // What has become of the move, in zero, one or two moves.
  void send(const HeldMove& held);
  [[nodiscard]] MoveQueue& sent() { return sent_; }

 private:
  [[nodiscard]] Point point_at(planar::Vec centre_mm, double normal_mm) const;
  Move& push(const HeldMove& held, const Point& end_mm);
  void send_line(const HeldMove& held, const Point& end_mm);
  void send_arc(const HeldMove& held, const planar::ContourElement& arc, double normal_mm);

  Plane plane_ = Plane::xy;
  PlaneAxes axes_ = axes_of(Plane::xy);
  planar::Vec shift_mm_;
  Point place_mm_{};
  MoveQueue sent_;
};

}  // namespace kerf::parser
