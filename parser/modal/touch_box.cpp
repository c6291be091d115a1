#include "parser/modal/touch_box.hpp"

#include <algorithm>

namespace kerf::parser {

namespace {

constexpr double kRounding_mm = 1e-6;

// The stretch of a way, as parts of its length, that lies in the block.
struct Inside {
  double begin = -TouchBox::kFar_mm;
  double end = TouchBox::kFar_mm;
  std::size_t begin_axis = 0;  // whose face it passes there
  std::size_t end_axis = 0;
};

Inside stretch_in(const TouchBox& box, const Point& from_mm, const Point& to_mm) {
  Inside in;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double way = to_mm[axis] - from_mm[axis];
    if (way == 0.0) {
      const bool within = from_mm[axis] >= box.min_mm[axis] - kRounding_mm &&
                          from_mm[axis] <= box.max_mm[axis] + kRounding_mm;
      in.end = within ? in.end : -TouchBox::kFar_mm;
      continue;
    }
    const double to_min = (box.min_mm[axis] - from_mm[axis]) / way;
    const double to_max = (box.max_mm[axis] - from_mm[axis]) / way;
    if (const double begin = std::min(to_min, to_max); begin > in.begin) {
      in.begin = begin;
      in.begin_axis = axis;
    }
    if (const double end = std::max(to_min, to_max); end < in.end) {
      in.end = end;
      in.end_axis = axis;
    }
  }
  return in;
}

struct Face {
  std::size_t axis = 0;
  bool upper = false;
};

// On the face exactly, so that the next look at the point finds it there.
Point point_on_face(const TouchBox& box, const Point& from_mm, const Point& to_mm, double part,
                    const Face& face) {
  Point point;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = from_mm[i] + part * (to_mm[i] - from_mm[i]);
  }
  point[face.axis] = face.upper ? box.max_mm[face.axis] : box.min_mm[face.axis];
  return point;
}

}  // namespace

bool touches(const TouchBox& box, const Point& tip_mm) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(tip_mm[axis] >= box.min_mm[axis] - kRounding_mm &&
          tip_mm[axis] <= box.max_mm[axis] + kRounding_mm)) {
      return false;
    }
  }
  return true;
}

std::optional<Point> first_contact(const TouchBox& box, const Point& from_mm, const Point& to_mm) {
  const Inside in = stretch_in(box, from_mm, to_mm);
  if (!(in.begin <= in.end && in.begin >= 0.0 && in.begin <= 1.0)) {
    return std::nullopt;
  }
  const bool down = to_mm[in.begin_axis] < from_mm[in.begin_axis];
  return point_on_face(box, from_mm, to_mm, in.begin, {in.begin_axis, down});
}

std::optional<Point> last_contact(const TouchBox& box, const Point& from_mm, const Point& to_mm) {
  const Inside in = stretch_in(box, from_mm, to_mm);
  if (!(in.end <= 1.0)) {
    return std::nullopt;
  }
  if (in.end <= 0.0) {
    return from_mm;
  }
  const bool up = to_mm[in.end_axis] > from_mm[in.end_axis];
  return point_on_face(box, from_mm, to_mm, in.end, {in.end_axis, up});
}

}  // namespace kerf::parser
