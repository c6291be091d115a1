#include "smoothing/run_parts.hpp"

#include <utility>

namespace kerf::smoothing {

namespace {

// The lines from to to of the run, on the curve that is theirs.
PathPart part_of(curves::Curve curve, const Polyline& run, const MergedCurve& merged,
                 std::size_t from, std::size_t to, const parser::Move& like) {
  const double s_begin = merged.s_mm[from - merged.first];
  PathPart part{.curve = std::move(curve)};
  const Vertex& line = run[from + 1];
  part.source = line.source;
  part.run_block = line.run_block;
  part.feedrate_mm_s = line.feedrate_mm_s;
  part.extra = {.begin_rad_mm = like.extra.begin_rad_mm, .end_rad_mm = like.extra.end_rad_mm};
  part.mode = parser::PathMode::blend;
  part.corner_tolerance_mm = like.blend_tolerance_mm;
  part.departure_mm = merged.departure_mm;
  if (const auto* arc = std::get_if<curves::Arc>(&merged.curve)) {
    part.arc_normal = arc->normal_axis();
  }
  part.continues = merged.continues || from > merged.first;
  if (to - from > 1) {
    for (std::size_t i = from; i < to; ++i) {
      part.marks.push_back({.s_mm = merged.s_mm[i - merged.first] - s_begin,
                            .line = run[i + 1].source.line,
                            .run_block = run[i + 1].run_block});
    }
  }
  return part;
}

}  // namespace

void append_parts(const Polyline& run, const MergedCurve& merged, const parser::Move& like,
                  std::vector<PathPart>& parts) {
  const double length = curves::length_mm(merged.curve);
  for (std::size_t from = merged.first; from < merged.last;) {
    std::size_t to = from + 1;
    while (to < merged.last && run[to + 1].feedrate_mm_s == run[from + 1].feedrate_mm_s) {
      ++to;
    }
    if (from == merged.first && to == merged.last) {
      parts.push_back(part_of(merged.curve, run, merged, from, to, like));
      return;
    }
    const double s_end = to < merged.last ? merged.s_mm[to - merged.first] : length;
    const curves::Stretch stretch{merged.s_mm[from - merged.first], s_end};
    if (stretch.begin_mm < stretch.end_mm) {
      if (auto cut = curves::part(merged.curve, stretch)) {
        parts.push_back(part_of(std::move(*cut), run, merged, from, to, like));
      }
    }
    from = to;
  }
}

}  // namespace kerf::smoothing
