#include "smoothing/run_parts.hpp"

#include <utility>

namespace kerf::smoothing {

namespace {

// What is shorter is no part: a line that stands across the curve of its run has next to no way on
// it, however long it is.
constexpr double kShortestPart_mm = 1e-9;

// Lines of a run that become one part.
struct PartLines {
  std::size_t from = 0;
  std::size_t to = 0;
  double feedrate_mm_s = 0.0;
};

// Those of one feedrate from `from` on. Where they are too short to be a part, those of the next
// feedrate with them; so with what is too short at the curve's end.
PartLines lines_of_part(const Polyline& run, const MergedCurve& merged, std::size_t from) {
  const auto s_mm = [&merged](std::size_t vertex) {
    return vertex < merged.last ? merged.s_mm[vertex - merged.first]
                                : curves::length_mm(merged.curve);
  };
  PartLines lines{.from = from, .to = from};
  do {
    lines.feedrate_mm_s = run[lines.to + 1].feedrate_mm_s;
    do {
      ++lines.to;
    } while (lines.to < merged.last && run[lines.to + 1].feedrate_mm_s == lines.feedrate_mm_s);
  } while (lines.to < merged.last && s_mm(lines.to) - s_mm(from) < kShortestPart_mm);
  if (s_mm(merged.last) - s_mm(lines.to) < kShortestPart_mm) {
    lines.to = merged.last;
  }
  return lines;
}

// The lines of the run, on the curve that is theirs.
PathPart part_of(curves::Curve curve, const Polyline& run, const MergedCurve& merged,
                 const PartLines& lines, const parser::Move& like) {
  const auto [from, to, feedrate_mm_s] = lines;
  const double s_begin = merged.s_mm[from - merged.first];
  PathPart part{.curve = std::move(curve)};
  const Vertex& line = run[from + 1];
  part.source = line.source;
  part.run_block = line.run_block;
  part.feedrate_mm_s = feedrate_mm_s;
  part.extra = {.begin_rad_mm = like.extra.begin_rad_mm, .end_rad_mm = like.extra.end_rad_mm};
  part.mode = parser::PathMode::blend;
  part.corner_tolerance_mm = like.blend_tolerance_mm;
  part.deviation_mm = merged.deviation_mm;
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
    const PartLines lines = lines_of_part(run, merged, from);
    if (from == merged.first && lines.to == merged.last) {
      parts.push_back(part_of(merged.curve, run, merged, lines, like));
      return;
    }
    const double s_end = lines.to < merged.last ? merged.s_mm[lines.to - merged.first] : length;
    const curves::Stretch stretch{merged.s_mm[from - merged.first], s_end};
    if (stretch.begin_mm < stretch.end_mm) {
      if (auto cut = curves::part(merged.curve, stretch)) {
        parts.push_back(part_of(std::move(*cut), run, merged, lines, like));
      }
    }
    from = lines.to;
  }
}

}  // namespace kerf::smoothing
