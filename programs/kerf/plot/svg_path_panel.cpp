#include "programs/kerf/plot/svg_path_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/plot/feed_colours.hpp"
#include "programs/kerf/report/axis_ticks.hpp"

namespace kerf::program {

namespace {

constexpr double kBarWidth = 14.0;
constexpr double kBarRoom = 92.0;
constexpr double kOtherRoom = 48.0;   // more, for numbers of another unit
constexpr double kBarNumbers = 48.0;  // how wide those of mm/s are
constexpr double kMargin = 34.0;
constexpr const char* kDeviationColour = "#b0203a";
constexpr std::size_t kNamedLines = 8;
constexpr double kLineWidth = 1.8;
constexpr double kSmallestView_mm = 0.01;  // of a path that is a point
constexpr double kGridRoom = 34.0;         // for numbers at the left and at the bottom

const Stroke kFrame{.colour = "#c8ccd2"};
const Stroke kRapid{.colour = "#a9b0b8", .width = 1.0, .dashes = "4 3"};
const Stroke kGrid{.colour = "#eceff2"};

// Paper to pixels.
class Scale {
 public:
  Scale(const PaperBox& box, const PixelBox& place) {
    const double width = std::max(box.width_mm(), 1e-9);
    const double height = std::max(box.height_mm(), 1e-9);
    pixels_per_mm_ =
        std::min({place.width / width, place.height / height, place.width / kSmallestView_mm});
    origin_ = {.x = place.left + (place.width - box.width_mm() * pixels_per_mm_) / 2.0 -
                    box.min.u_mm * pixels_per_mm_,
               .y = place.bottom() - (place.height - box.height_mm() * pixels_per_mm_) / 2.0 +
                    box.min.v_mm * pixels_per_mm_};
  }

  [[nodiscard]] Pixel at(const PaperPoint& p) const noexcept {
    return {.x = origin_.x + p.u_mm * pixels_per_mm_, .y = origin_.y - p.v_mm * pixels_per_mm_};
  }
  [[nodiscard]] PaperPoint back(const Pixel& p) const noexcept {
    return {.u_mm = (p.x - origin_.x) / pixels_per_mm_, .v_mm = (origin_.y - p.y) / pixels_per_mm_};
  }
  [[nodiscard]] double pixels_per_mm() const noexcept { return pixels_per_mm_; }

 private:
  double pixels_per_mm_ = 1.0;
  Pixel origin_{};
};

// Numbered lines of x and y, where paper and machine coordinates are the same.
void draw_grid(SvgCanvas& canvas, const PixelBox& frame, const Scale& scale) {
  const PaperPoint low = scale.back({.x = frame.left, .y = frame.bottom()});
  const PaperPoint high = scale.back({.x = frame.right(), .y = frame.top});
  for (const double x : axis_ticks({.min = low.u_mm, .max = high.u_mm}, 8)) {
    const double at = scale.at({.u_mm = x}).x;
    canvas.line({.x = at, .y = frame.top}, {.x = at, .y = frame.bottom()}, kGrid);
    canvas.text({.x = at, .y = frame.bottom() + 16.0}, fmt::format("{:g}", x),
                {.anchor = Anchor::middle, .size = 11.0});
  }
  for (const double y : axis_ticks({.min = low.v_mm, .max = high.v_mm}, 6)) {
    const double at = scale.at({.v_mm = y}).y;
    canvas.line({.x = frame.left, .y = at}, {.x = frame.right(), .y = at}, kGrid);
    canvas.text({.x = frame.left - 6.0, .y = at + 4.0}, fmt::format("{:g}", y),
                {.anchor = Anchor::end, .size = 11.0});
  }
  canvas.text({.x = frame.right() - 6.0, .y = frame.bottom() - 7.0}, "x, y in mm",
              {.anchor = Anchor::end, .size = 11.0, .colour = "#888"});
}

// Which way x, y and z go, and how long some millimetres are.
void draw_tripod(SvgCanvas& canvas, const PixelBox& frame, const Scale& scale) {
  const Pixel origin{.x = frame.left + 44.0, .y = frame.bottom() - 40.0};
  constexpr double kArm = 26.0;
  for (std::size_t k = 0; k < 3; ++k) {
    curves::Position unit{};
    unit[k] = 1.0;
    const PaperPoint arm = project(View::isometric, unit);
    canvas.line(origin, {.x = origin.x + arm.u_mm * kArm, .y = origin.y - arm.v_mm * kArm},
                {.colour = "#666", .width = 1.2});
    canvas.text(
        {.x = origin.x + arm.u_mm * (kArm + 10.0), .y = origin.y - arm.v_mm * (kArm + 10.0) + 4.0},
        std::string(1, "xyz"[k]), {.anchor = Anchor::middle, .size = 11.0});
  }
  const double length_mm = round_down(120.0 / scale.pixels_per_mm());
  const double right = frame.right() - 14.0;
  const double left = right - length_mm * scale.pixels_per_mm();
  const double y = frame.bottom() - 14.0;
  canvas.line({.x = left, .y = y}, {.x = right, .y = y}, {.colour = "#666", .width = 2.0});
  canvas.text({.x = (left + right) / 2.0, .y = y - 6.0}, fmt::format("{:g} mm", length_mm),
              {.anchor = Anchor::middle, .size = 11.0});
}

// Numbers of the unit after those of mm/s.
void draw_other_numbers(SvgCanvas& canvas, const PixelBox& bar, double max_v_mm_s, FeedUnit unit) {
  const double left = bar.right() + kBarNumbers;
  const double factor = per_mm_s(unit);
  for (const double v : axis_ticks({.min = 0.0, .max = factor * max_v_mm_s}, 6)) {
    const double y = bar.bottom() - v / (factor * max_v_mm_s) * bar.height;
    canvas.line({.x = left, .y = y}, {.x = left + 4.0, .y = y}, {.colour = "#666"});
    canvas.text({.x = left + 8.0, .y = y + 4.0}, fmt::format("{:g}", v), {.size = 11.0});
  }
  canvas.line({.x = left, .y = bar.top}, {.x = left, .y = bar.bottom()}, {.colour = "#666"});
  canvas.text({.x = left, .y = bar.top - 10.0}, name_of(unit), {.size = 11.0});
}

void draw_colour_bar(SvgCanvas& canvas, const PixelBox& bar, double max_v_mm_s, FeedUnit unit) {
  const double step = bar.height / static_cast<double>(kColourLevels);
  for (std::size_t level = 0; level < kColourLevels; ++level) {
    const std::string colour = colour_of(level);
    canvas.box({.left = bar.left,
                .top = bar.bottom() - step * static_cast<double>(level + 1),
                .width = bar.width,
                .height = step},
               colour, {.colour = colour, .width = 0.5});
  }
  for (const double v : axis_ticks({.min = 0.0, .max = max_v_mm_s}, 6)) {
    const double y = bar.bottom() - v / max_v_mm_s * bar.height;
    canvas.line({.x = bar.right(), .y = y}, {.x = bar.right() + 4.0, .y = y}, {.colour = "#666"});
    canvas.text({.x = bar.right() + 8.0, .y = y + 4.0}, fmt::format("{:g}", v), {.size = 11.0});
  }
  if (unit == FeedUnit::mm_s) {
    canvas.text({.x = bar.left, .y = bar.top - 10.0}, "feedrate, mm/s", {.size = 11.0});
    return;
  }
  canvas.text({.x = bar.left, .y = bar.top - 10.0}, "mm/s", {.size = 11.0});
  draw_other_numbers(canvas, bar, max_v_mm_s, unit);
}

void draw_rapid_key(SvgCanvas& canvas, const Pixel& at) {
  canvas.line(at, {.x = at.x + 22.0, .y = at.y}, kRapid);
  canvas.text({.x = at.x + 28.0, .y = at.y + 4.0}, "rapid", {.size = 11.0});
}

// The lines of each colour; the last level is for rapids.
using Runs = std::array<std::vector<std::vector<Pixel>>, kColourLevels + 1>;

Runs runs_of(const std::vector<OutlinePoint>& points, const Scale& scale, double max_v_mm_s) {
  Runs runs;
  std::size_t level = kColourLevels + 1;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].hidden) {
      level = kColourLevels + 1;
      continue;
    }
    const std::size_t here = level_to(i, points, max_v_mm_s);
    if (here != level) {
      runs[here].push_back({scale.at(points[i - 1].at)});
      level = here;
    }
    runs[here].back().push_back(scale.at(points[i].at));
  }
  return runs;
}

// Rapids at the bottom and the slowest on top: where lines cross, that is what one looks for.
void draw_path(SvgCanvas& canvas, const std::vector<OutlinePoint>& points, const Scale& scale,
               const PlotData& data) {
  const double max_v_mm_s = data.max_feedrate_mm_s();
  const double width = std::max(kLineWidth, data.outline().line_width_mm() * scale.pixels_per_mm());
  const Runs runs = runs_of(points, scale, max_v_mm_s);
  for (std::size_t level = kColourLevels + 1; level-- > 0;) {
    if (!runs[level].empty()) {
      canvas.polylines(runs[level], level == kColourLevels
                                        ? kRapid
                                        : Stroke{.colour = colour_of(level), .width = width});
    }
  }
  const Stroke ring{.colour = "#222", .width = 1.4};
  canvas.dot(scale.at(points.back().at), 4.5, "none", ring);
  canvas.dot(scale.at(points.front().at), 2.5, "#222", ring);
}

// Outwards from the middle of the picture, where there is room.
void draw_lines(SvgCanvas& canvas, const PixelBox& frame, const Scale& scale,
                const std::vector<SharpPlace>& places) {
  for (const SharpPlace& place : places) {
    const Pixel at = scale.at(place.at);
    const bool left = at.x < frame.left + 0.5 * frame.width;
    const bool above = at.y < frame.top + 0.5 * frame.height;
    canvas.dot(at, 2.0, "#fff", {.colour = "#222", .width = 0.8});
    canvas.text({.x = at.x + (left ? -5.0 : 5.0), .y = at.y + (above ? -5.0 : 12.0)},
                fmt::format("line {}", place.line),
                {.anchor = left ? Anchor::end : Anchor::start, .size = 10.0, .colour = "#222"});
  }
}

// A program that was stopped may not have come there.
void draw_deviation(SvgCanvas& canvas, const PixelBox& frame, const Pixel& at,
                    const smoothing::PathDeviation& deviation) {
  if (at.x < frame.left || at.x > frame.right() || at.y < frame.top || at.y > frame.bottom()) {
    return;
  }
  canvas.dot(at, 6.0, "none", {.colour = kDeviationColour, .width = 1.6});
  const bool right_half = at.x > 0.5 * (frame.left + frame.right());
  const bool upper_half = at.y < 0.5 * (frame.top + frame.bottom());
  canvas.text({.x = at.x + (right_half ? -10.0 : 10.0), .y = at.y + (upper_half ? 18.0 : -10.0)},
              fmt::format("deviation {:.2g} mm", deviation.distance_mm),
              {.anchor = right_half ? Anchor::end : Anchor::start,
               .size = 11.0,
               .colour = kDeviationColour});
}

}  // namespace

void draw_path_panel(SvgCanvas& canvas, const PixelBox& place, const PlotData& data,
                     const PathPanel& panel) {
  const std::vector<OutlinePoint> points = data.outline().points();
  const PixelBox frame{.left = place.left + kGridRoom,
                       .top = place.top,
                       .width = place.width - kGridRoom - kBarRoom -
                                (panel.feed_unit == FeedUnit::mm_s ? 0.0 : kOtherRoom),
                       .height = place.height - kGridRoom};
  if (points.empty()) {
    canvas.box(frame, "none", kFrame);
    return;
  }
  const double max_v_mm_s = data.max_feedrate_mm_s();
  const Scale scale(box_around(points), {.left = frame.left + kMargin,
                                         .top = frame.top + kMargin,
                                         .width = frame.width - 2.0 * kMargin,
                                         .height = frame.height - 2.0 * kMargin});
  if (data.view() == View::top) {
    draw_grid(canvas, frame, scale);
  } else {
    draw_tripod(canvas, frame, scale);
  }
  canvas.clip(frame);
  draw_path(canvas, points, scale, data);
  canvas.end_clip();
  canvas.box(frame, "none", kFrame);
  draw_lines(canvas, frame, scale, data.sharp_places().sharpest(kNamedLines));
  if (panel.deviation) {
    draw_deviation(canvas, frame, scale.at(project(data.view(), panel.deviation->at_mm)),
                   *panel.deviation);
  }
  const PixelBox bar{.left = frame.right() + 20.0,
                     .top = frame.top + 22.0,
                     .width = kBarWidth,
                     .height = frame.height - 22.0};
  if (max_v_mm_s > 0.0) {
    draw_colour_bar(canvas, bar, max_v_mm_s, panel.feed_unit);
  }
  if (std::any_of(points.begin(), points.end(), [](const OutlinePoint& p) { return p.rapid; })) {
    draw_rapid_key(canvas, {.x = bar.left, .y = bar.bottom() + 17.0});
  }
}

}  // namespace kerf::program
