#include "programs/kerf/plot/svg_limit_panel.hpp"

#include <algorithm>
#include <vector>

namespace kerf::program {

namespace {

constexpr double kCaption = 20.0;
constexpr double kBand = 18.0;
constexpr double kRow = 18.0;
constexpr double kPatch = 11.0;
constexpr std::size_t kColumns = 5;

// Each once, in the order of their numbers.
std::vector<Constraint> limits_in(std::span<const LimitBand::Interval> intervals) {
  std::vector<Constraint> limits;
  for (const LimitBand::Interval& interval : intervals) {
    limits.push_back(interval.limit);
  }
  std::sort(limits.begin(), limits.end());
  limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
  return limits;
}

}  // namespace

double limit_panel_height(std::span<const LimitBand::Interval> intervals) {
  const std::size_t rows = (limits_in(intervals).size() + kColumns - 1) / kColumns;
  return rows > 0 ? kCaption + kBand + kRow * static_cast<double>(rows) + kPatch : 0.0;
}

void draw_limit_panel(SvgCanvas& canvas, const PixelBox& frame, const LimitPanel& panel) {
  canvas.text({.x = frame.left, .y = frame.top + kCaption - 7.0}, "limited by",
              {.size = 12.0, .bold = true});
  const double top = frame.top + kCaption;
  const double scale = frame.width / static_cast<double>(std::max<std::int64_t>(panel.end_tick, 1));
  for (std::size_t i = 0; i < panel.intervals.size(); ++i) {
    const bool last = i + 1 == panel.intervals.size();
    const std::int64_t end = last ? panel.end_tick : panel.intervals[i + 1].tick;
    const std::int64_t begin = std::min(panel.intervals[i].tick, end);
    canvas.box({.left = frame.left + scale * static_cast<double>(begin),
                .top = top,
                .width = scale * static_cast<double>(end - begin),
                .height = kBand},
               colour_of(panel.intervals[i].limit), {.colour = "none"});
  }
  const std::vector<Constraint> limits = limits_in(panel.intervals);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const auto column = static_cast<double>(i % kColumns);
    const std::size_t row = i / kColumns;
    const double x = frame.left + column * frame.width / static_cast<double>(kColumns);
    const double y = top + kBand + 7.0 + static_cast<double>(row) * kRow;
    canvas.box({.left = x, .top = y, .width = kPatch, .height = kPatch}, colour_of(limits[i]),
               {.colour = "none"});
    canvas.text({.x = x + kPatch + 5.0, .y = y + kPatch - 1.5}, text_of(limits[i]), {.size = 11.0});
  }
}

}  // namespace kerf::program
