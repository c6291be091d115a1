#include "kernel/plan_notes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

namespace kerf {

namespace {

// What is longer is cut.
template <typename... Values>
void tell(const PlanNotes::Sink& sink, const char* format, const Values&... values) {
  std::array<char, 240> line{};
  const int length = std::snprintf(line.data(), line.size(), format, values...);
  if (length > 0) {
    sink({line.data(), std::min(static_cast<std::size_t>(length), line.size() - 1)});
  }
}

}  // namespace

void PlanNotes::pushed(const lookahead::Block& block) const {
  if (block.limit_curve.empty()) {
    tell(sink_, "line %u: block of %.6f mm, at most %.3f mm/s", block.line, block.length_mm,
         block.limits.feedrate_mm_s);
    return;
  }
  const auto [low, high] =
      std::ranges::minmax(block.limit_curve, {}, &lookahead::FeedSample::v_mm_s);
  tell(sink_, "line %u: scan of %.6f mm at %zu places, %.3f mm/s at u = %.6f to %.3f mm/s",
       block.line, block.length_mm, block.limit_curve.size(), low.v_mm_s, low.u, high.v_mm_s);
}

void PlanNotes::cut(const lookahead::BlockCuts& cuts) const {
  tell(sink_, "line %u: %zu breaking points, noise included; %zu velocity segments", cuts.line,
       cuts.breaking_points, cuts.velocity_segments);
}

void PlanNotes::planned(const lookahead::PlannedSegment& segment) const {
  constexpr double kSame = 1.0 - 1e-9;
  const std::string kind(segment.kind);
  tell(sink_, "line %u: segment from s = %.6f mm, %.6f mm, %s: %.3f to %.3f to %.3f mm/s in %.6f s",
       segment.line, segment.s_begin_mm, segment.length_mm, kind.c_str(), segment.v_begin_mm_s,
       segment.v_cruise_mm_s, segment.v_end_mm_s, segment.duration_s);
  if (segment.v_end_mm_s < kSame * segment.v_end_allowed_mm_s) {
    tell(sink_, "line %u: its end is adjusted, from %.3f to %.3f mm/s", segment.line,
         segment.v_end_allowed_mm_s, segment.v_end_mm_s);
  }
}

void PlanNotes::searched(const lookahead::PlanSearch& search) const {
  const char* from = search.from_rest ? "from rest" : "in motion";
  if (!search.has_plan) {
    tell(sink_, "search over %zu cells %s: no plan", search.cells, from);
    return;
  }
  tell(sink_, "search over %zu cells %s: %.6f s after %d Newton steps%s", search.cells, from,
       search.duration_s, search.newton_steps, search.slowed_down ? ", slowed down" : "");
}

void PlanNotes::took_classical(std::size_t blocks) const {
  tell(sink_, "the classical plan takes %zu blocks", blocks);
}

}  // namespace kerf
