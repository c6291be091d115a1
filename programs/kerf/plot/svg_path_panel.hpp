// The upper part of the plot.
#pragma once

#include <optional>

#include "programs/kerf/plot/plot_data.hpp"
#include "programs/kerf/plot/svg_canvas.hpp"
#include "smoothing/path_deviations.hpp"

namespace kerf::program {

// The path, the same scale both ways, with a colour bar at its right side. deviation: where the
// path is farthest from the programmed one, if it is to be marked.
void draw_path_panel(SvgCanvas& canvas, const PixelBox& place, const PlotData& data,
                     const std::optional<smoothing::PathDeviation>& deviation);

}  // namespace kerf::program
