// The upper part of the plot.
#pragma once

#include "programs/plot_data.hpp"
#include "programs/svg_canvas.hpp"

namespace kerf::program {

// The path, the same scale both ways, with a colour bar at its right side.
void draw_path_panel(SvgCanvas& canvas, const PixelBox& place, const PlotData& data);

}  // namespace kerf::program
