// The curves that take the place of a run's lines, as path segments, with their deviation from the
// lines.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "curves/curve.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/path_deviations.hpp"
#include "smoothing/path_segment.hpp"
#include "smoothing/polyline.hpp"
#include "smoothing/run_fit.hpp"
#include "smoothing/run_segments.hpp"

namespace kerf::smoothing {

// How far lines that become one in G61 may leave it: rounding.
inline constexpr double kExact_mm = 1e-9;

class RunCurves {
 public:
  explicit RunCurves(const RunFitSettings& settings) : settings_(settings) {}

  // A new run begins, with this move, whose lines are beside_mm from the program.
  void begin(const parser::Move& like, double beside_mm);
  // What comes of the run from now on lies no farther than that from the program, beside what
  // begin() says.
  void widen_beside(double distance_mm);

  // In which the run's last segment so far ends.
  [[nodiscard]] const std::optional<Eigen::Vector3d>& end_direction() const noexcept {
    return end_direction_;
  }
  [[nodiscard]] const parser::Move& like() const noexcept { return like_; }
  [[nodiscard]] const RunFitSettings& settings() const noexcept { return settings_; }
  // Of all segments appended.
  [[nodiscard]] const PathDeviations& deviations() const noexcept { return deviations_; }

  // The lines up to this vertex, which are as good as on a line, as one.
  void append_line(const Polyline& run, std::size_t vertex, std::vector<PathSegment>& out);
  // As an arc. False: they are none.
  bool append_circle(const Polyline& run, std::size_t vertex, std::vector<PathSegment>& out);
  // As the first spans of a fit.
  struct Spans {
    std::size_t count = 0;
    bool continue_segment = false;  // the first goes on from the segment before
    bool to_vertex = false;         // the last ends in its vertex, exactly
  };
  void append_spans(const Polyline& run, const RunFit& fit, const Spans& spans,
                    std::vector<PathSegment>& out);
  // The first line as it is, except that it begins at begin_mm, which is no farther from the first
  // vertex than the tolerance.
  void append_first_line(const Polyline& run, const curves::Position& begin_mm,
                         std::vector<PathSegment>& out);

 private:
  // Of spans or lines: those before `last`.
  struct Indices {
    std::size_t first = 0;
    std::size_t last = 0;
  };
  struct ChordEnds {
    curves::Position begin_mm{};
    curves::Position end_mm{};
  };
  struct FitSegment {
    Indices spans;
    bool continues = false;
    bool to_vertex = false;
  };
  // On the curve, beside a vertex.
  struct Place {
    const Vertex& vertex;
    curves::Position at_mm{};
  };
  void append_segment(const Polyline& run, const RunFit& fit, const FitSegment& segment,
                      std::vector<PathSegment>& out);
  void append_chords(const Polyline& run, const Indices& lines, const ChordEnds& ends,
                     std::vector<PathSegment>& out);
  void append_merged(const Polyline& run, MergedCurve merged, std::vector<PathSegment>& out);
  void widen(const Place& place, double distance_mm);

  void set_beside(double beside_mm);

  RunFitSettings settings_;
  parser::Move like_{};     // data common to the moves of the run
  double beside_mm_ = 0.0;  // of the run's lines as they came
  bool broken_ = false;     // the last segment is lines where a spline was meant to go on
  std::optional<Eigen::Vector3d> end_direction_;
  PathDeviations deviations_;
};

}  // namespace kerf::smoothing
