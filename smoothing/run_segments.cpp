#include "smoothing/run_segments.hpp"

#include <cassert>
#include <utility>

namespace kerf::smoothing {

namespace {

// What is shorter is no segment: a line that stands across the curve of its run has next to no way
// on it, however long it is.
constexpr double kShortestSegment_mm = 1e-9;

// Lines of a run that become one segment.
struct SegmentLines {
  std::size_t from = 0;
  std::size_t to = 0;
  std::size_t feedrate_of = 0;  // the vertex that has it
};

// Those of one feedrate from `from` on. Where they are too short to be a segment, those of the next
// feedrate with them; so with what is too short at the curve's end.
SegmentLines lines_of_segment(const Polyline& run, const MergedCurve& merged, std::size_t from) {
  const auto s_mm = [&merged](std::size_t vertex) {
    return vertex < merged.last ? merged.s_mm[vertex - merged.first]
                                : curves::length_mm(merged.curve);
  };
  SegmentLines lines{.from = from, .to = from};
  do {
    lines.feedrate_of = lines.to + 1;
    do {
      ++lines.to;
    } while (lines.to < merged.last &&
             is_of_one_feedrate(run[lines.to + 1], run[lines.feedrate_of]));
  } while (lines.to < merged.last && s_mm(lines.to) - s_mm(from) < kShortestSegment_mm);
  if (s_mm(merged.last) - s_mm(lines.to) < kShortestSegment_mm) {
    lines.to = merged.last;
  }
  return lines;
}

// The lines of the run, on the curve that is theirs.
PathSegment segment_of(curves::Curve curve, const Polyline& run, const MergedCurve& merged,
                       const SegmentLines& lines, const parser::Move& like) {
  const auto [from, to, feedrate_of] = lines;
  const double s_begin = merged.s_mm[from - merged.first];
  PathSegment segment{.curve = std::move(curve)};
  const Vertex& line = run[from + 1];
  segment.source = line.source;
  segment.run_block = line.run_block;
  segment.feedrate_mm_s = run[feedrate_of].feedrate_mm_s;
  segment.follows = run[feedrate_of].follows;
  segment.extra = {.begin_rad_mm = like.auxiliary.begin_rad_mm,
                   .end_rad_mm = like.auxiliary.end_rad_mm};
  segment.mode = like.mode;
  segment.corner_tolerance_mm = like.blend_tolerance_mm;
  segment.deviation_mm = merged.deviation_mm;
  if (const auto* arc = std::get_if<curves::Arc>(&merged.curve)) {
    segment.arc_normal = arc->normal_axis();
  }
  segment.continues = merged.continues || from > merged.first;
  if (to - from > 1) {
    for (std::size_t i = from; i < to; ++i) {
      segment.marks.push_back({.s_mm = merged.s_mm[i - merged.first] - s_begin,
                               .line = run[i + 1].source.program_line(),
                               .run_block = run[i + 1].run_block});
    }
  }
  return segment;
}

}  // namespace

void append_segments(const Polyline& run, const MergedCurve& merged, const parser::Move& like,
                     std::vector<PathSegment>& segments) {
  assert(merged.first < merged.last && merged.last < run.size());
  const double length = curves::length_mm(merged.curve);
  for (std::size_t from = merged.first; from < merged.last;) {
    const SegmentLines lines = lines_of_segment(run, merged, from);
    if (from == merged.first && lines.to == merged.last) {
      segments.push_back(segment_of(merged.curve, run, merged, lines, like));
      return;
    }
    const double s_end = lines.to < merged.last ? merged.s_mm[lines.to - merged.first] : length;
    const curves::Stretch stretch{merged.s_mm[from - merged.first], s_end};
    if (stretch.begin_mm < stretch.end_mm) {
      if (auto cut = curves::part(merged.curve, stretch)) {
        segments.push_back(segment_of(std::move(*cut), run, merged, lines, like));
      }
    }
    from = lines.to;
  }
}

}  // namespace kerf::smoothing
