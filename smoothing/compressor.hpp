// Turns runs of short lines into curves: moves in, path segments out, with a window of some hundred
// lines.
//
// Idea. A run ends where the program means a corner (polyline.hpp); between its corners it becomes
// one spline, four times continuously differentiable, or a line or an arc where it is one. A long
// run is fitted window by window: the front part of a window's curve is final once the lines after
// it can hardly change it any more, and the next window's curve goes on from its end point and its
// first four derivatives there. Where no spline of reasonable spans stays within the
// tolerance there is a corner after all; a line alone stays as it is. So every result is within the
// tolerance, as measured.
//
// A line that is much shorter than the tolerance is none of the path's: the next one begins where
// it begins, or the run's last line ends where it ends. Between two long lines it would keep their
// corner from being blended.
//
// In G61 only short lines that go on in the same direction, at the same feedrate, become one:
// within a nanometre, which is rounding.
//
// The window counts lines and knows nothing of how the text was read: the same program always gives
// the same path.
//
// Weakness. Coarse arcs, whose chords rise by more than some tolerances, stay lines with blended
// corners.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "curves/curve.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/path_deviations.hpp"
#include "smoothing/path_segment.hpp"
#include "smoothing/polyline.hpp"
#include "smoothing/run_curves.hpp"

namespace kerf::smoothing {

class Compressor {
 public:
  // What a move does not say.
  struct About {
    double beside_mm = 0.0;    // how far the run's lines are from the program, less than the
                               // tolerance; of the run's first move counts
    bool has_changes = false;  // outputs change where it begins: it is kept, however short
  };

  // travel: no curve leaves it.
  explicit Compressor(const std::optional<curves::Extents>& travel) : curves_({.travel = travel}) {}

  // A straight feed of X, Y and Z alone, to a usable place, in G64 with a merging tolerance, or a
  // short one in G61.
  [[nodiscard]] static bool takes(const parser::Move& move);
  // It can be part of the run that is held. If not, flush first.
  [[nodiscard]] bool continues(const parser::Move& move) const;

  // Precondition: takes() and, unless empty, continues(). A move of no length is left out.
  void push(const parser::Move& move, std::vector<PathSegment>& out) { push(move, out, {}); }
  void push(const parser::Move& move, std::vector<PathSegment>& out, const About& about);
  // The run ends with what was pushed.
  void flush(std::vector<PathSegment>& out);

  [[nodiscard]] const PathDeviations& deviations() const noexcept { return curves_.deviations(); }

 private:
  static constexpr std::size_t kWindow = 400;  // lines

  // In G61 the run is a line, and the move goes on in its direction.
  [[nodiscard]] bool goes_straight_on(const parser::Move& move) const;
  void narrow_straight_on();
  // Where the last move ended. Precondition: the run is not empty.
  [[nodiscard]] const Vertex& last() const { return short_ ? *short_ : run_.back(); }
  // Unless it has no length.
  void append(Vertex vertex);
  void append_short();
  // Parts leave until more lines are needed, or all, if the run has ended.
  void reduce(bool ended, std::vector<PathSegment>& out);
  // The first corner that is known, up to the vertex before which all are.
  std::optional<std::size_t> find_corner(std::size_t known);
  // The run up to this vertex is all there is between two corners.
  void close_at(std::size_t vertex, std::vector<PathSegment>& out);
  // The front of a run that goes on.
  void advance(std::size_t known, std::vector<PathSegment>& out);
  // All vertices up to this one are as good as on a line, in order.
  [[nodiscard]] bool is_straight_to(std::size_t vertex) const {
    return is_straight(run_, vertex, tolerance_mm());
  }
  [[nodiscard]] double tolerance_mm() const { return curves_.settings().tolerance_mm; }
  void drop_front(std::size_t vertices);

  RunCurves curves_;
  Polyline run_;                 // from where it has not left yet
  std::optional<Vertex> short_;  // after it: the end of lines too short to be of the path
  std::vector<curves::Position> left_out_;  // since the run's last vertex
  std::size_t scanned_ = 0;                 // vertices up to here are no corners
  std::size_t straight_ = 0;         // up to here the run is straight; 0: it is not known to be
  std::size_t awaited_ = kWindow;    // vertices before the next look
  std::vector<std::size_t> breaks_;  // of the last window, after what has left
  std::optional<SplineTail> tail_;   // the run's front has left as a spline
  // In G61: of lines from the run's begin on, close enough to all its vertices.
  Eigen::AlignedBox3d straight_on_;
};

}  // namespace kerf::smoothing
