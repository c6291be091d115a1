// Under the curves: a band coloured by the active constraint, and its legend.
#pragma once

#include <cstdint>
#include <span>

#include "programs/kerf/plot/svg_canvas.hpp"
#include "programs/kerf/report/limit_band.hpp"

namespace kerf::program {

// Of the band and its legend; 0 where there is no interval.
[[nodiscard]] double limit_panel_height(std::span<const LimitBand::Interval> intervals);

struct LimitPanel {
  std::span<const LimitBand::Interval> intervals{};
  std::int64_t end_tick = 0;
};

// From the frame's top on, as wide as the frame.
void draw_limit_panel(SvgCanvas& canvas, const PixelBox& frame, const LimitPanel& panel);

}  // namespace kerf::program
