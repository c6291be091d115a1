#include "lookahead/split.hpp"

#include <algorithm>

#include "lookahead/breaking_points.hpp"

namespace kerf::lookahead {

namespace {

// Between samples half a tick apart any change of slope is a candidate here; the second step and
// the comparison with the neighbours sort out what is a valley.
constexpr double kScreening_mm_s = 0.0;

struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;  // included
};

Slope rise_of(const Ceiling& ceiling, const SampleRange& range, std::size_t top) {
  std::vector<Slope::Sample> samples;
  for (std::size_t i = range.first; i <= top; ++i) {
    samples.push_back({ceiling[i].s_mm - ceiling[range.first].s_mm, ceiling[i].v_mm_s});
  }
  return Slope(std::move(samples));
}

Slope fall_of(const Ceiling& ceiling, const SampleRange& range, std::size_t top) {
  std::vector<Slope::Sample> samples;
  for (std::size_t i = range.last + 1; i-- > top;) {
    samples.push_back({ceiling[range.last].s_mm - ceiling[i].s_mm, ceiling[i].v_mm_s});
  }
  return Slope(std::move(samples));
}

Span span_between(const Block& block, const SampleRange& range) {
  const Ceiling& ceiling = block.ceiling;
  const auto at = [&ceiling](std::size_t i) {
    return ceiling.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const auto top = std::max_element(
      at(range.first), at(range.last + 1),
      [](const FeedSample& a, const FeedSample& b) { return a.v_mm_s < b.v_mm_s; });
  const auto top_index = static_cast<std::size_t>(top - ceiling.begin());
  Span span = whole_span(block);
  span.s_begin_mm = ceiling[range.first].s_mm;
  span.length_mm = ceiling[range.last].s_mm - span.s_begin_mm;
  span.end.feedrate_mm_s = ceiling[range.last].v_mm_s;
  span.ends_block = range.last + 1 == ceiling.size();
  span.rise = rise_of(ceiling, range, top_index);
  span.fall = fall_of(ceiling, range, top_index);
  return span;
}

}  // namespace

Span whole_span(const Block& block) {
  return {.length_mm = block.length_mm, .limits = block.limits, .end = {.feedrate_mm_s = 0.0}};
}

std::vector<Span> split(const Block& block) {
  if (block.ceiling.empty()) {
    return {whole_span(block)};
  }
  std::vector<Span> spans;
  std::size_t first = 0;
  for (const std::size_t valley :
       valleys(block.ceiling, breaking_points(block.ceiling, kScreening_mm_s))) {
    spans.push_back(span_between(block, {.first = first, .last = valley}));
    first = valley;
  }
  spans.push_back(span_between(block, {.first = first, .last = block.ceiling.size() - 1}));
  spans.back().end.feedrate_mm_s = 0.0;
  return spans;
}

}  // namespace kerf::lookahead
