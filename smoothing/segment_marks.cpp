#include "smoothing/segment_marks.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::smoothing {

void shift_marks(PathSegment& segment, double by_mm) {
  std::vector<LineMark>& marks = segment.marks;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const double s = marks[i].s_mm - by_mm;
    kept = s <= 0.0 ? 0 : kept;
    marks[kept] = marks[i];
    marks[kept].s_mm = std::max(s, 0.0);
    ++kept;
  }
  marks.resize(kept);
}

// At w the blend is way (1 - w)^3 before the corner and way w^3 after it. It passes the corner at
// 1 / 2, where that is an eighth of the way: marks nearer to the corner are looked for from there.
std::vector<LineMark> marks_along(const Blend& blend, double way_mm, const PathSegment& before,
                                  const PathSegment& after) {
  const double length = curves::length_mm(before.curve);
  std::vector<LineMark> marks;
  // From there to the place of the blend that is nearest to the mark's.
  const auto beside = [&](const curves::Position& place, double w) {
    double s = blend.curve.s_at(w);
    for (int i = 0; i < 2; ++i) {
      const curves::PathDerivatives at = blend.curve.derivatives_at(s);
      s += (curves::vec(place) - curves::vec(at.position_mm)).dot(curves::vec(at.first));
    }
    return s;
  };
  const auto add = [&](LineMark mark, double s_mm) {
    mark.s_mm = marks.empty() ? 0.0 : std::max(s_mm, marks.back().s_mm);
    if (marks.empty() || marks.back().run_block != mark.run_block) {
      marks.push_back(mark);
    }
  };
  add(before.mark_at(length - way_mm), 0.0);
  for (const LineMark& mark : before.marks) {
    const double behind = length - mark.s_mm;
    if (behind < way_mm && behind > 0.0) {
      const double w = std::min(1.0 - std::cbrt(behind / way_mm), 0.5);
      const double s = beside(curves::position_at(before.curve, mark.s_mm), w);
      add(mark, std::min(s, blend.s_corner_mm));
    }
  }
  add(after.mark_at(0.0), blend.s_corner_mm);
  for (const LineMark& mark : after.marks) {
    if (mark.s_mm > 0.0 && mark.s_mm < way_mm) {
      const double w = std::max(std::cbrt(mark.s_mm / way_mm), 0.5);
      add(mark, beside(curves::position_at(after.curve, mark.s_mm), w));
    }
  }
  return marks;
}

}  // namespace kerf::smoothing
