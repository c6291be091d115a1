#include "programs/kerf/plot/svg_time_panel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/report/axis_ticks.hpp"

namespace kerf::program {

namespace {

constexpr std::string_view kLimitColour = "#b3261e";
// A limit so far above the curve is written instead of drawn: the curve would be a flat line.
constexpr double kFarLimit = 4.0;
// From so many ticks a band on, some half of a pixel, a curve would be a solid bar.
constexpr std::int64_t kBandTicks = 16;

double top_of(double largest) noexcept {
  constexpr double kRounding = 1e-9;  // of a curve that is 0
  return 1.1 * (largest > kRounding ? largest : 1.0);
}

double time_to_x(const PixelBox& frame, const TimeAxis& axis, double units) noexcept {
  return frame.left + frame.width * units / axis.end;
}

double value_to_y(const PixelBox& frame, const ValueRange& range, double value) noexcept {
  return frame.bottom() - (value - range.min) / range.width() * frame.height;
}

// Steps at their own tick: a curve that holds its value until the next point would lie about v.
std::vector<Pixel> pixels_of(const std::vector<SeriesPoint>& points, const PixelBox& frame,
                             const TimeAxis& axis, const ValueRange& range) {
  std::vector<Pixel> pixels;
  pixels.reserve(points.size());
  for (const SeriesPoint& point : points) {
    pixels.push_back(
        {.x = time_to_x(frame, axis, static_cast<double>(point.tick) / axis.ticks_per_unit),
         .y = value_to_y(frame, range, point.value)});
  }
  return pixels;
}

void draw_limit(SvgCanvas& canvas, const PixelBox& frame, double y) {
  canvas.line({.x = frame.left, .y = y}, {.x = frame.right(), .y = y},
              {.colour = std::string(kLimitColour), .width = 1.0, .dashes = "5 4"});
}

}  // namespace

TimeAxis time_axis(std::int64_t last_tick, double period_s) {
  const double seconds = std::max(static_cast<double>(last_tick), 1.0) * period_s;
  const bool hours = seconds > 4.0 * 3600.0;
  const bool minutes = !hours && seconds > 600.0;
  const double unit_s = hours ? 3600.0 : minutes ? 60.0 : 1.0;
  return {.ticks_per_unit = unit_s / period_s,
          .unit = hours     ? "h"
                  : minutes ? "min"
                            : "s",
          .end = seconds / unit_s};
}

namespace {

void draw_grid(SvgCanvas& canvas, const PixelBox& frame, const ValueRange& range,
               const TimeAxis& axis) {
  for (const double value : axis_ticks(range, 4)) {
    const double y = value_to_y(frame, range, value);
    canvas.line({.x = frame.left, .y = y}, {.x = frame.right(), .y = y},
                {.colour = value == 0.0 ? "#b5bac2" : "#eceff2"});
    canvas.text({.x = frame.left - 6.0, .y = y + 4.0}, fmt::format("{:g}", value),
                {.anchor = Anchor::end, .size = 11.0});
  }
  for (const double t : axis_ticks({.min = 0.0, .max = axis.end}, 9)) {
    const double x = time_to_x(frame, axis, t);
    canvas.line({.x = x, .y = frame.top}, {.x = x, .y = frame.bottom()}, {.colour = "#eceff2"});
  }
}

// Around the largest values there and the smallest back.
std::vector<Pixel> band_of(const MinMaxSeries& series, const PixelBox& frame, const TimeAxis& axis,
                           const ValueRange& range) {
  const std::vector<SeriesBand> bands = series.bands();
  const double half = static_cast<double>(series.ticks_per_band()) / 2.0;
  const auto at = [&](const SeriesBand& band, double value) {
    const double middle = static_cast<double>(band.tick) + half;
    return Pixel{.x = std::min(time_to_x(frame, axis, middle / axis.ticks_per_unit), frame.right()),
                 .y = value_to_y(frame, range, value)};
  };
  std::vector<Pixel> outline;
  outline.reserve(2 * bands.size());
  for (const SeriesBand& band : bands) {
    outline.push_back(at(band, band.max));
  }
  for (auto band = bands.rbegin(); band != bands.rend(); ++band) {
    outline.push_back(at(*band, band->min));
  }
  return outline;
}

void draw_right_numbers(SvgCanvas& canvas, const PixelBox& frame, const ValueRange& range,
                        double factor) {
  for (const double value : axis_ticks({.min = factor * range.min, .max = factor * range.max}, 4)) {
    const double y = value_to_y(frame, range, value / factor);
    canvas.line({.x = frame.right() - 4.0, .y = y}, {.x = frame.right(), .y = y},
                {.colour = "#666"});
    canvas.text({.x = frame.right() + 6.0, .y = y + 4.0}, fmt::format("{:g}", value),
                {.size = 11.0});
  }
}

}  // namespace

void draw_time_panel(SvgCanvas& canvas, const PixelBox& frame, const TimeCurve& curve,
                     const TimeAxis& axis) {
  const std::vector<SeriesPoint> points = curve.series->points();
  double peak = 0.0;
  for (const SeriesPoint& point : points) {
    peak = std::max(peak, std::abs(point.value));
  }
  const bool has_limit = std::isfinite(curve.limit) && curve.limit > 0.0;
  const bool draws_limit = has_limit && (peak == 0.0 || curve.limit <= kFarLimit * peak);
  const double top = top_of(std::max(draws_limit ? curve.limit : 0.0, peak));
  const ValueRange range{.min = curve.is_signed ? -top : 0.0, .max = top};
  draw_grid(canvas, frame, range, axis);
  if (draws_limit) {
    draw_limit(canvas, frame, value_to_y(frame, range, curve.limit));
    if (curve.is_signed) {
      draw_limit(canvas, frame, value_to_y(frame, range, -curve.limit));
    }
  }
  if (curve.right_factor > 0.0) {
    draw_right_numbers(canvas, frame, range, curve.right_factor);
  }
  if (curve.series->ticks_per_band() < kBandTicks) {
    const std::vector<std::vector<Pixel>> line{pixels_of(points, frame, axis, range)};
    canvas.polylines(line, {.colour = std::string(curve.colour), .width = 1.1});
  } else {
    canvas.area(band_of(*curve.series, frame, axis, range), curve.colour);
  }
  canvas.box(frame, "none", {.colour = "#c8ccd2"});
  canvas.text({.x = frame.left, .y = frame.top - 7.0}, curve.label, {.size = 12.0, .bold = true});
  if (has_limit) {
    canvas.text({.x = frame.right(), .y = frame.top - 7.0},
                fmt::format("limit {:g}{}", curve.limit, draws_limit ? "" : " (far above)"),
                {.anchor = Anchor::end, .size = 11.0, .colour = kLimitColour});
  }
}

void draw_time_numbers(SvgCanvas& canvas, const PixelBox& frame, const TimeAxis& axis) {
  for (const double t : axis_ticks({.min = 0.0, .max = axis.end}, 9)) {
    canvas.text({.x = time_to_x(frame, axis, t), .y = frame.bottom() + 16.0},
                fmt::format("{:g}", t), {.anchor = Anchor::middle, .size = 11.0});
  }
  canvas.text({.x = frame.right(), .y = frame.bottom() + 32.0}, fmt::format("time, {}", axis.unit),
              {.anchor = Anchor::end, .size = 11.0, .colour = "#888"});
}

}  // namespace kerf::program
