#include "smoothing/output_changes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "smoothing/blender.hpp"

namespace kerf::smoothing {

namespace {

// A change that would come closer than this to the one before or to the end comes a little sooner.
constexpr double kShortestPart_mm = 1e-6;

bool begins(const PathSegment& segment, std::uint64_t block) {
  return segment.run_block == block ||
         std::ranges::any_of(segment.marks,
                             [&](const LineMark& mark) { return mark.run_block == block; });
}

// Precondition: the segment has marks, and the stretch is no shorter than kShortestPart_mm.
PathSegment part_of(const PathSegment& segment, const curves::Stretch& stretch) {
  PathSegment part = segment;
  part.curve = *curves::part(segment.curve, stretch);
  std::erase_if(part.marks, [&](const LineMark& mark) { return mark.s_mm >= stretch.end_mm; });
  shift_marks(part, stretch.begin_mm);
  part.source = {.line = part.marks.front().line, .column = segment.source.column};
  part.run_block = part.marks.front().run_block;
  part.continues = segment.continues || stretch.begin_mm > 0.0;
  if (!begins(part, segment.corner_block)) {
    part.corner_block = 0;
  }
  return part;
}

}  // namespace

void OutputChanges::come_with(std::uint64_t block, std::vector<parser::EventMove> changes) {
  if (!changes.empty()) {
    waiting_.push_back({.block = block, .changes = std::move(changes)});
  }
}

void OutputChanges::cut(PathSegment segment, std::vector<PathSegment>& out) {
  struct Place {
    double s_mm = 0.0;
    std::vector<parser::EventMove> changes{};
  };
  const double length_mm = curves::length_mm(segment.curve);
  std::vector<Place> places{{}};
  // Also of moves that have no mark of their own.
  const auto look = [&](const LineMark& mark) {
    for (; !waiting_.empty() && waiting_.front().block <= mark.run_block; waiting_.pop_front()) {
      if (std::min(mark.s_mm - places.back().s_mm, length_mm - mark.s_mm) >= kShortestPart_mm) {
        places.push_back({.s_mm = mark.s_mm});
      }
      std::ranges::move(waiting_.front().changes, std::back_inserter(places.back().changes));
    }
  };
  look(segment.mark_at(0.0));
  std::ranges::for_each(segment.marks, look);
  if (places.size() == 1) {
    segment.changes = std::move(places.front().changes);
    out.push_back(std::move(segment));
    return;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_last = i + 1 == places.size();
    PathSegment& part = out.emplace_back(
        part_of(segment, {places[i].s_mm, is_last ? length_mm : places[i + 1].s_mm}));
    part.changes = std::move(places[i].changes);
  }
}

}  // namespace kerf::smoothing
