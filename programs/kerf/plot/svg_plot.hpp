// The picture of a run: the path coloured by feedrate, and v, a, j and the chord error over time
// under it; of a curve also the scan over u.
#pragma once

#include <optional>
#include <string>

#include "lookahead/path/limits.hpp"
#include "programs/kerf/feed_unit.hpp"
#include "programs/kerf/plot/plot_data.hpp"
#include "smoothing/path_deviations.hpp"

namespace kerf::program {

struct PlotCaption {
  std::string title;
  std::string subtitle;
  double period_s = 0.001;
  lookahead::MotionLimits limits{};  // along the path; drawn where they are finite
  double chord_tolerance_mm = lookahead::kUnbounded;
  std::optional<smoothing::PathDeviation> deviation{};
  FeedUnit feed_unit = FeedUnit::mm_s;  // beside mm/s
};

// A whole SVG document.
[[nodiscard]] std::string svg_plot(const PlotData& data, const PlotCaption& caption);

}  // namespace kerf::program
