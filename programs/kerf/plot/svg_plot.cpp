#include "programs/kerf/plot/svg_plot.hpp"

#include <array>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/plot/svg_canvas.hpp"
#include "programs/kerf/plot/svg_limit_panel.hpp"
#include "programs/kerf/plot/svg_path_panel.hpp"
#include "programs/kerf/plot/svg_scan_panel.hpp"
#include "programs/kerf/plot/svg_time_panel.hpp"

namespace kerf::program {

namespace {

constexpr double kWidth = 960.0;
constexpr double kEdge = 24.0;
constexpr double kHeading = 66.0;
constexpr double kPathHeight = 560.0;
constexpr double kCurveHeight = 120.0;
constexpr double kScanHeight = 200.0;
constexpr double kCurveGap = 34.0;
constexpr double kCurveLeft = 76.0;
constexpr double kFoot = 44.0;
constexpr double kRightNumbers = 64.0;  // in place of the edge

std::string v_label(FeedUnit unit) {
  return unit == FeedUnit::mm_s ? "v, mm/s"
                                : fmt::format("v, mm/s; at the right {}", name_of(unit));
}

}  // namespace

std::string svg_plot(const PlotData& data, const PlotCaption& caption) {
  const bool has_unit = caption.feed_unit != FeedUnit::mm_s;
  const double right = has_unit ? kRightNumbers : kEdge;
  const std::array<TimeCurve, 4> curves{
      {{.label = v_label(caption.feed_unit),
        .series = &data.v(),
        .limit = caption.limits.velocity_mm_s,
        .colour = "#1f5fa8",
        .right_factor = has_unit ? per_mm_s(caption.feed_unit) : 0.0},
       {.label = "a, mm/s\u00b2",
        .series = &data.a(),
        .limit = caption.limits.acceleration_mm_s2,
        .is_signed = true,
        .colour = "#1b7f5c"},
       {.label = "j, mm/s\u00b3",
        .series = &data.j(),
        .limit = caption.limits.jerk_mm_s3,
        .is_signed = true,
        .colour = "#7a4fa3"},
       {.label = "chord error, \u00b5m",
        .series = &data.chord_error_um(),
        .limit = 1e3 * caption.chord_tolerance_mm,
        .colour = "#8a6d1a"}}};
  const double curves_height = static_cast<double>(curves.size()) * (kCurveHeight + kCurveGap);
  const std::vector<LimitBand::Interval> band =
      data.limits() ? data.limits()->intervals() : std::vector<LimitBand::Interval>{};
  SvgCanvas canvas(kWidth, kHeading + kPathHeight + curves_height + kFoot +
                               limit_panel_height(band) +
                               (data.scan() ? kCurveGap + kScanHeight + kCurveGap : 0.0));
  canvas.text({.x = kEdge, .y = 32.0}, caption.title,
              {.size = 19.0, .colour = "#222", .bold = true});
  canvas.text({.x = kEdge, .y = 52.0}, caption.subtitle, {.size = 13.0, .colour = "#666"});
  draw_path_panel(
      canvas,
      {.left = kEdge, .top = kHeading, .width = kWidth - 2.0 * kEdge, .height = kPathHeight}, data,
      {.deviation = caption.deviation, .feed_unit = caption.feed_unit});
  const TimeAxis axis = time_axis(data.last_tick(), caption.period_s);
  PixelBox frame{.left = kCurveLeft,
                 .top = kHeading + kPathHeight + kCurveGap,
                 .width = kWidth - kCurveLeft - right,
                 .height = kCurveHeight};
  for (const TimeCurve& curve : curves) {
    draw_time_panel(canvas, frame, curve, axis);
    if (&curve == &curves.back()) {
      draw_time_numbers(canvas, frame, axis);
    }
    frame.top += kCurveHeight + kCurveGap;
  }
  if (!band.empty()) {
    frame.top += kFoot - kCurveGap;
    draw_limit_panel(canvas, frame, {.intervals = band, .end_tick = data.last_tick()});
    frame.top += limit_panel_height(band);
  }
  if (data.scan()) {
    frame.top += kCurveGap;
    frame.height = kScanHeight;
    draw_scan_panel(canvas, frame, *data.scan());
  }
  return canvas.take();
}

}  // namespace kerf::program
