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
  double beside_mm = 0.0;                   // the lines' own distance from the program
  std::optional<curves::Extents> travel{};  // no curve leaves it
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
// path turns, and where the curve is too far from the lines. The tolerance counts up to the vertex
// `judged`; after it the distance may be any.
//
// The distance is taken between the points of curve and lines at the same length, which is no less
// than the distance of either from the other, at vertices and between them; a bound of how far the
// curve can bend between two such places is added.
struct RunStretch {
  std::size_t last = 0;  // the first is vertex 0
  std::size_t judged = 0;
  bool pinned = false;
  // In which the path comes to the first, if that is known.
  std::optional<Eigen::Vector3d> before{};
};
RunFit fit_run(const Polyline& run, const RunStretch& stretch,
               const std::optional<SplineTail>& tail, std::span<const std::size_t> breaks,
               const RunFitSettings& settings);

// Within the tolerance a spline of few short lines may begin and end in any direction. At a corner
// that makes the joint sharper than the lines have it, up to a cusp in which the tool would rest.
// Holds such ends in the direction of their lines. What is not known to join an end counts as going
// straight on. False: no more of them are held than before.
bool hold_ends(const Polyline& run, const RunStretch& stretch, const SplineFit& spline,
               double tolerance_mm, FitEnds& ends);

class SpanBreaks {
 public:
  struct Settings {
    std::size_t last = 0;       // vertex; the first is 0
    double before_mm = 0.0;     // length of the span that the spline continues; 0: none
    double tolerance_mm = 0.0;  // of merging
  };

  // given: the first of them, as an earlier fit had them; may be none.
  SpanBreaks(const Polyline& run, std::span<const std::size_t> given, const Settings& settings);

  // In order, from 0 to the last.
  [[nodiscard]] const std::vector<std::size_t>& vertices() const noexcept { return vertices_; }
  [[nodiscard]] std::size_t span_count() const noexcept { return vertices_.size() - 1; }

  // Half of a span may not be too short beside what came before and cannot be divided any more.
  [[nodiscard]] bool is_divisible(std::size_t span) const;
  // Each of these spans becomes two, and so do neighbours that would be long beside them.
  // Precondition: they are divisible, and there is a flag for each span.
  void divide(std::vector<bool> spans);

 private:
  [[nodiscard]] double w_mm(std::size_t vertex) const { return (*run_)[vertex].w_mm; }
  [[nodiscard]] double length_mm(std::size_t span) const {
    return w_mm(vertices_[span + 1]) - w_mm(vertices_[span]);
  }
  void place();
  void grade(std::vector<bool>& spans) const;

  const Polyline* run_;
  Settings settings_;
  std::vector<std::size_t> vertices_;
};

}  // namespace kerf::smoothing
