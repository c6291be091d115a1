// A stretch of a run of short lines as a spline within a tolerance.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "curves/position.hpp"
#include "smoothing/polyline.hpp"
#include "smoothing/spline_fit.hpp"

namespace kerf::smoothing {

struct RunFitSettings {
  double tolerance_mm = 0.0;
  std::optional<curves::Extents> travel{};  // what of it no curve leaves
};

struct RunFit {
  SplineFit spline;
  std::vector<std::size_t> breaks;  // vertices, the ends of the spans
  std::vector<double> away_mm;      // of each span: its distance from the lines, at the most
  // Nothing: all of it is within the tolerance. Else the vertex at which it is not.
  std::optional<std::size_t> fails_at{};
};

// Fits the vertices first to last. The run's begin is a point of the curve unless a tail is given,
// its end if pinned. breaks: where spans should end, of an earlier fit; more are added where the
// path turns, and where the curve is too far from the lines. Places that count are those up to the
// vertex `judged`; beyond it the distance may be any.
//
// The distance is taken between the points of curve and lines at the same length, which is no less
// than the distance of either from the other, at vertices and between them; what the curve can bend
// between two such places is added.
struct RunStretch {
  std::size_t last = 0;  // the first is vertex 0
  std::size_t judged = 0;
  bool pinned = false;
};
RunFit fit_run(const Polyline& run, const RunStretch& stretch,
               const std::optional<SplineTail>& tail, std::span<const std::size_t> breaks,
               const RunFitSettings& settings);

}  // namespace kerf::smoothing
