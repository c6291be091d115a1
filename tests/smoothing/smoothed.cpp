#include "tests/smoothing/smoothed.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "smoothing/segment_builder.hpp"

namespace kerf::test {

using curves::Position;
using curves::vec;
using smoothing::PathSegment;
using smoothing::Smoother;

namespace {

constexpr double kRise_mm = 1e-5;  // of a curve over the chord between two of its points
constexpr int kHalvings = 20;
constexpr double kGap_mm = 1e-9;  // between two segments, and how well a place on either is known

double to_segment_mm(const Position& point, const Position& from, const Position& to) {
  const Eigen::Vector3d chord = vec(to) - vec(from);
  const Eigen::Vector3d seen = vec(point) - vec(from);
  const double squared = chord.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(seen.dot(chord) / squared, 0.0, 1.0) : 0.0;
  return (seen - share * chord).norm();
}

// The points after the begin of the stretch, up to its end.
void add_stretch(const curves::Curve& curve, const curves::Stretch& stretch, int halvings,
                 std::vector<Position>& points) {
  const Position begin = curves::position_at(curve, stretch.begin_mm);
  const Position end = curves::position_at(curve, stretch.end_mm);
  const double way = stretch.end_mm - stretch.begin_mm;
  const auto rises = [&](double share) {
    const Position at = curves::position_at(curve, stretch.begin_mm + share * way);
    return to_segment_mm(at, begin, end) > kRise_mm;
  };
  if (halvings < kHalvings && (rises(0.5) || rises(0.25) || rises(0.75))) {
    const double middle = stretch.begin_mm + 0.5 * way;
    add_stretch(curve, {stretch.begin_mm, middle}, halvings + 1, points);
    add_stretch(curve, {middle, stretch.end_mm}, halvings + 1, points);
  } else {
    points.push_back(end);
  }
}

// The pieces of a curve are short where it turns sharply.
void add_points(const curves::Curve& curve, std::vector<Position>& points) {
  const int segments = std::holds_alternative<curves::NurbsCurve>(curve) ? 2 : 4;  // of a piece
  if (points.empty()) {
    points.push_back(curves::position_at(curve, 0.0));
  }
  curves::for_each_piece(curve, [&](const curves::Piece& piece) {
    const double begin = curves::s_begin_mm(piece);
    const double step = (curves::s_end_mm(piece) - begin) / segments;
    for (int i = 0; i < segments; ++i) {
      add_stretch(curve, {begin + i * step, begin + (i + 1) * step}, 0, points);
    }
  });
}

std::vector<double> lengths_along(const std::vector<Position>& points) {
  std::vector<double> lengths{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    lengths.push_back(lengths.back() + (vec(points[i]) - vec(points[i - 1])).norm());
  }
  return lengths;
}

double farthest_mm(const std::vector<Position>& path, const std::vector<Position>& other) {
  const std::vector<double> along = lengths_along(path);
  const std::vector<double> along_other = lengths_along(other);
  const double ratio = along_other.back() / along.back();
  const double reach = 2.0 + 0.05 * along_other.back();
  double farthest = 0.0;
  std::size_t near = 1;  // ends a segment that is near the place before
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double about = along[i] * ratio;
    // The end of the segment that reaches so far.
    const auto end_at = [&along_other](double s_mm) {
      const auto end = std::lower_bound(along_other.begin() + 1, along_other.end() - 1, s_mm);
      return static_cast<std::size_t>(end - along_other.begin());
    };
    const auto away_mm = [&](std::size_t k) {
      return to_segment_mm(path[i], other[k - 1], other[k]);
    };
    const std::size_t last = end_at(about + reach);
    std::size_t k = end_at(about - reach);
    near = std::clamp(near, k, last);
    while (near < last && away_mm(near + 1) <= away_mm(near)) {
      ++near;
    }
    double nearest = away_mm(near);
    // What is no farther than another place was changes nothing.
    while (k <= last && nearest > farthest) {
      nearest = std::min(nearest, away_mm(k));
      // As long a way on from here nothing is nearer than that.
      const double way = (vec(path[i]) - vec(other[k])).norm() - nearest;
      k = std::max(k + 1, end_at(along_other[k] + way));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

// Precondition: a line, an arc or a NURBS.
Position end_of(const parser::Move& move) {
  if (const auto* line = std::get_if<parser::LineMove>(&move.shape)) {
    return line->end_mm;
  }
  if (const auto* nurbs = std::get_if<parser::NurbsMove>(&move.shape)) {
    return nurbs->points.back().position_mm;
  }
  return std::get<parser::ArcMove>(move.shape).end_mm;
}

}  // namespace

Smoothed smooth(const std::vector<parser::Move>& moves) {
  Smoother smoother({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 50000.0});
  Smoothed smoothed;
  const auto take = [&] {
    Smoother::Output output;
    while (smoother.next(output)) {
      if (auto* segment = std::get_if<PathSegment>(&output)) {
        smoothed.segments.push_back(std::move(*segment));
      }
    }
  };
  for (const parser::Move& move : moves) {
    if (!smoother.push(move)) {
      return {};
    }
    take();
  }
  smoother.flush();
  take();
  smoothed.deviation = smoother.deviations().largest;
  return smoothed;
}

std::vector<Position> points_of(const std::vector<parser::Move>& moves) {
  std::vector<Position> points;
  for (const parser::Move& move : moves) {
    std::vector<PathSegment> segments;
    if (smoothing::append_segments(move, segments)) {
      for (const PathSegment& segment : segments) {
        add_points(segment.curve, points);
      }
    }
  }
  return points;
}

std::vector<Position> points_of(const Smoothed& smoothed) {
  std::vector<Position> points;
  for (const PathSegment& segment : smoothed.segments) {
    add_points(segment.curve, points);
  }
  return points;
}

double apart_mm(const std::vector<Position>& path, const std::vector<Position>& other) {
  return std::max(farthest_mm(path, other), farthest_mm(other, path));
}

std::string faults_of_junctions(const std::vector<parser::Move>& moves, const Smoothed& smoothed) {
  std::ostringstream faults;
  Position at = moves.front().start_mm;
  const PathSegment* before = nullptr;
  for (const PathSegment& segment : smoothed.segments) {
    const auto begin = curves::derivatives_at(segment.curve, 0.0);
    const double gap = (vec(begin.position_mm) - vec(at)).norm();
    if (gap > kGap_mm) {
      faults << "gap of " << gap << " mm before line " << segment.source.line << "; ";
    }
    if (segment.continues && before != nullptr) {
      const auto end = curves::derivatives_at(before->curve, curves::length_mm(before->curve));
      const double turn = (vec(end.first) - vec(begin.first)).norm();
      const double bend = (vec(end.second_per_mm) - vec(begin.second_per_mm)).norm();
      const double curvature = vec(end.second_per_mm).norm();
      // Where a curve all but stands still its radius is of nanometres.
      const double allowed_turn = 1e-8 + 0.1 * kGap_mm * curvature;
      const double allowed_bend =
          1e-6 * (1.0 + curvature) + kGap_mm * vec(begin.third_per_mm2).norm();
      if (turn > allowed_turn || bend > allowed_bend) {
        faults << "turn " << turn << ", bend " << bend << " of " << curvature << " before line "
               << segment.source.line << "; ";
      }
    }
    at = curves::position_at(segment.curve, curves::length_mm(segment.curve));
    before = &segment;
  }
  const double miss = (vec(at) - vec(end_of(moves.back()))).norm();
  if (miss > kGap_mm) {
    faults << "ends " << miss << " mm off";
  }
  return faults.str();
}

}  // namespace kerf::test
