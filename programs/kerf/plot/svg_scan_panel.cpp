#include "programs/kerf/plot/svg_scan_panel.hpp"

#include <algorithm>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/report/axis_ticks.hpp"

namespace kerf::program {

namespace {

constexpr std::string_view kScanColour = "#b3261e";
constexpr std::string_view kRunColour = "#1f5fa8";
constexpr double kRoom = 1.1;  // of the frame's height over the highest feedrate

class Panel {
 public:
  Panel(SvgCanvas& canvas, const PixelBox& frame, const ScannedCurve& curve)
      : canvas_(canvas), frame_(frame), curve_(curve) {
    for (const lookahead::FeedSample& sample : curve.scan()) {
      top_mm_s_ = std::max(top_mm_s_, kRoom * sample.v_mm_s);
    }
  }

  void draw_grid() {
    for (const double v : axis_ticks({.min = 0.0, .max = top_mm_s_}, 4)) {
      canvas_.line({frame_.left, y_of(v)}, {frame_.right(), y_of(v)}, {.colour = "#eceff2"});
      canvas_.text({.x = frame_.left - 6.0, .y = y_of(v) + 4.0}, fmt::format("{:g}", v),
                   {.anchor = Anchor::end, .size = 11.0});
    }
    const ValueRange u{.min = curve_.scan().front().u, .max = curve_.scan().back().u};
    for (const double at : axis_ticks(u, 9)) {
      canvas_.text({.x = x_of(curve_.share_of(at)), .y = frame_.bottom() + 16.0},
                   fmt::format("{:g}", at), {.anchor = Anchor::middle, .size = 11.0});
    }
  }

  void draw_blocks() {
    for (const std::size_t i : curve_.breaking_points()) {
      const double x = x_of(curve_.share_of(curve_.scan()[i].u));
      canvas_.line({x, frame_.top}, {x, frame_.bottom()}, {.colour = "#d7dbe0", .dashes = "2 3"});
    }
  }

  void draw_curves() {
    MinMaxSeries scan;
    for (const lookahead::FeedSample& sample : curve_.scan()) {
      scan.add(static_cast<std::int64_t>(curve_.share_of(sample.u) * ScannedCurve::kSteps),
               sample.v_mm_s);
    }
    draw(scan, kScanColour);
    draw(curve_.planned(), kRunColour);
    for (const std::size_t i : curve_.breaking_points()) {
      const lookahead::FeedSample& at = curve_.scan()[i];
      canvas_.dot({x_of(curve_.share_of(at.u)), y_of(at.v_mm_s)}, 2.2, kScanColour,
                  {.colour = "none"});
    }
  }

  void draw_words() {
    canvas_.box(frame_, "none", {.colour = "#c8ccd2"});
    canvas_.text({.x = frame_.left, .y = frame_.top - 7.0},
                 fmt::format("v over u, mm/s, of the curve in line {}", curve_.line()),
                 {.size = 12.0, .bold = true});
    canvas_.text({.x = frame_.right(), .y = frame_.top - 7.0},
                 fmt::format("scanned, {} breaking points, {} blocks",
                             curve_.breaking_points().size(), curve_.breaking_points().size() - 1),
                 {.anchor = Anchor::end, .size = 11.0, .colour = kScanColour});
  }

 private:
  [[nodiscard]] double x_of(double share) const { return frame_.left + share * frame_.width; }
  [[nodiscard]] double y_of(double v_mm_s) const {
    return frame_.bottom() - v_mm_s / top_mm_s_ * frame_.height;
  }
  void draw(const MinMaxSeries& series, std::string_view colour) {
    std::vector<Pixel> line;
    for (const SeriesPoint& point : series.points()) {
      line.push_back(
          {x_of(static_cast<double>(point.tick) / ScannedCurve::kSteps), y_of(point.value)});
    }
    const std::vector<std::vector<Pixel>> lines{line};
    canvas_.polylines(lines, {.colour = std::string(colour), .width = 1.1});
  }

  SvgCanvas& canvas_;
  const PixelBox& frame_;
  const ScannedCurve& curve_;
  double top_mm_s_ = 0.0;
};

}  // namespace

void draw_scan_panel(SvgCanvas& canvas, const PixelBox& frame, const ScannedCurve& curve) {
  Panel panel(canvas, frame, curve);
  panel.draw_grid();
  panel.draw_blocks();
  panel.draw_curves();
  panel.draw_words();
}

}  // namespace kerf::program
