// The lower part of the plot: one curve over time.
#pragma once

#include <string>
#include <string_view>

#include "programs/kerf/plot/svg_canvas.hpp"
#include "programs/kerf/report/min_max_series.hpp"

namespace kerf::program {

// The unit of the time axis, chosen so that its numbers stay short.
struct TimeAxis {
  double ticks_per_unit = 1000.0;
  std::string_view unit = "s";
  double end = 1.0;  // in units
};

[[nodiscard]] TimeAxis time_axis(std::int64_t last_tick, double period_s);

struct TimeCurve {
  std::string label;  // "v, mm/s"
  const MinMaxSeries* series = nullptr;
  double limit = 0.0;  // drawn where it is finite; also below zero if the curve is signed
  bool is_signed = false;
  std::string_view colour = "#1f5fa8";
  double right_factor =
      0.0;  // the numbers at the right are that many times those at the left; 0: none
};

void draw_time_panel(SvgCanvas& canvas, const PixelBox& frame, const TimeCurve& curve,
                     const TimeAxis& axis);

// The numbers under the last of the panels.
void draw_time_numbers(SvgCanvas& canvas, const PixelBox& frame, const TimeAxis& axis);

}  // namespace kerf::program
