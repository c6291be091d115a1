#include "smoothing/output_changes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "smoothing/segment_marks.hpp"

namespace kerf::smoothing {

namespace {

// Changes that are closer than this come together; one that is closer to the end comes so far from
// it.
constexpr double kShortestPart_mm = 1e-6;

bool begins_on(const PathSegment& part, std::uint64_t block) {
  return part.run_block == block || std::ranges::any_of(part.marks, [&](const LineMark& mark) {
           return mark.run_block == block;
         });
}

// A segment in parts. Of a row of many thousand lines each part has its own marks only.
class Parts {
 public:
  // Precondition: it has marks.
  explicit Parts(PathSegment segment)
      : curve_(std::move(segment.curve)),
        marks_(std::exchange(segment.marks, {})),
        like_(std::move(segment)) {}

  // Precondition: it begins with a mark and is no shorter than kShortestPart_mm.
  [[nodiscard]] PathSegment part(const curves::Stretch& stretch) const {
    PathSegment part = like_;
    part.curve = *curves::part(curve_, stretch);
    const auto first = std::ranges::upper_bound(marks_, stretch.begin_mm, {}, &LineMark::s_mm) - 1;
    part.marks.assign(first, std::ranges::lower_bound(marks_, stretch.end_mm, {}, &LineMark::s_mm));
    shift_marks(part, stretch.begin_mm);
    part.source.line = part.marks.front().line;
    part.run_block = part.marks.front().run_block;
    part.continues = like_.continues || stretch.begin_mm > 0.0;
    if (!begins_on(part, like_.corner_block)) {
      part.corner_block = 0;
    }
    return part;
  }

 private:
  curves::Curve curve_;
  std::vector<LineMark> marks_;
  PathSegment like_;
};

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
  // Also of moves that have no mark of their own. After the end there are marks of what a blend
  // took.
  const auto look = [&](const LineMark& mark) {
    if (mark.s_mm > 0.0 && mark.s_mm >= length_mm) {
      return;
    }
    const double s = std::min(mark.s_mm, length_mm - kShortestPart_mm);
    for (; !waiting_.empty() && waiting_.front().block <= mark.run_block; waiting_.pop_front()) {
      if (s - places.back().s_mm >= kShortestPart_mm) {
        places.push_back({.s_mm = s});
      }
      std::vector<parser::EventMove>& changes = waiting_.front().changes;
      std::move(changes.begin(), changes.end(), std::back_inserter(places.back().changes));
    }
  };
  look(segment.mark_at(0.0));
  for (const LineMark& mark : segment.marks) {
    look(mark);
  }
  if (places.size() == 1) {
    segment.changes = std::move(places.front().changes);
    out.push_back(std::move(segment));
    return;
  }
  const Parts parts(std::move(segment));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double end_mm = i + 1 < places.size() ? places[i + 1].s_mm : length_mm;
    out.push_back(parts.part({places[i].s_mm, end_mm}));
    out.back().changes = std::move(places[i].changes);
  }
}

}  // namespace kerf::smoothing
