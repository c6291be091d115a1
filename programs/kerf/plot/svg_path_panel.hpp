// The upper part of the plot.
#pragma once

#include <optional>

#include "programs/kerf/feed_unit.hpp"
#include "programs/kerf/plot/plot_data.hpp"
#include "programs/kerf/plot/svg_canvas.hpp"
#include "smoothing/path_deviations.hpp"

namespace kerf::program {

struct PathPanel {
  // Where the path is farthest from the programmed one, if it is to be marked.
  std::optional<smoothing::PathDeviation> deviation{};
  FeedUnit feed_unit = FeedUnit::mm_s;  // beside mm/s
};

// The path, the same scale both ways, with a colour bar at its right side.
void draw_path_panel(SvgCanvas& canvas, const PixelBox& place, const PlotData& data,
                     const PathPanel& panel);

}  // namespace kerf::program
