// Contours for cutter compensation: programmed moves, what comes of them, and how far the tool's
// centre is from the contour at closely spaced points.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "parser/compensation/cutter_compensation.hpp"
#include "program.hpp"

namespace kerf::parser {

// Builds moves in the plane XY, each on a line of its own, the first on line 1.
class Contour {
 public:
  explicit Contour(Point start_mm = {}) : at_mm_(start_mm) {}

  Contour& line(double x_mm, double y_mm) { return to({x_mm, y_mm, at_mm_[2]}, false); }
  Contour& rapid(double x_mm, double y_mm) { return to({x_mm, y_mm, at_mm_[2]}, true); }
  Contour& plunge(double z_mm) { return to({at_mm_[0], at_mm_[1], z_mm}, false); }
  Contour& to(Point end_mm, bool rapid) {
    Move& move = next();
    move.shape = LineMove{end_mm};
    move.rapid = rapid;
    at_mm_ = end_mm;
    return *this;
  }
  struct Arc {
    double x_mm;
    double y_mm;
    double centre_x_mm;
    double centre_y_mm;
    bool clockwise = false;
    int turns = 1;
  };
  Contour& arc(const Arc& arc) {
    Move& move = next();
    const Point end{arc.x_mm, arc.y_mm, at_mm_[2]};
    move.shape = ArcMove{
        Plane::xy, {arc.centre_x_mm, arc.centre_y_mm, at_mm_[2]}, end, arc.clockwise, arc.turns};
    at_mm_ = end;
    return *this;
  }
  Contour& dwell() {
    next().shape = DwellMove{1.0};
    return *this;
  }

  [[nodiscard]] const std::vector<Move>& moves() const { return moves_; }

 private:
  Move& next() {
    Move& move = moves_.emplace_back();
    move.source = {static_cast<std::uint32_t>(moves_.size()), 1};
    move.start_mm = at_mm_;
    move.feedrate_mm_s = 10.0;
    return move;
  }

  Point at_mm_;
  std::vector<Move> moves_;
};

struct Compensated {
  std::vector<Move> moves;
  std::vector<diagnostics::Diagnostic> diagnostics;

  [[nodiscard]] bool refused() const {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const diagnostics::Diagnostic& one) {
                         return one.severity == diagnostics::Severity::error;
                       });
  }
};

// All moves under compensation but the last, which is the exit.
inline Compensated compensated(const Contour& contour, const CompensationStart& start) {
  diagnostics::DiagnosticList list(100);
  CutterCompensation stage;
  Compensated result;
  const auto fetch = [&] {
    while (!stage.ready().empty()) {
      stage.ready().pop(result.moves.emplace_back());
    }
    for (ContourFault& fault : stage.faults()) {
      list.add_at(fault.place, *fault.page, fault.message);
    }
  };
  stage.start(start);
  for (std::size_t i = 0; i < contour.moves().size(); ++i) {
    if (i + 1 == contour.moves().size()) {
      stage.stop();
    }
    stage.take(contour.moves()[i], list.place(contour.moves()[i].source));
    fetch();
  }
  stage.finish(list.place({}));
  fetch();
  result.diagnostics = list.all();
  return result;
}

inline std::string text_of(const Compensated& result) {
  std::string text;
  for (const diagnostics::Diagnostic& one : result.diagnostics) {
    text += to_string(one, "").substr(1) + "\n";
  }
  for (const Move& move : result.moves) {
    text += text_of(move) + "\n";
  }
  return text;
}

// Points along a line or an arc in XY, ends included.
inline std::vector<Point> samples(const Move& move, double step_mm) {
  std::vector<Point> points;
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    const Point& a = move.start_mm;
    const Point& b = line->end_mm;
    const int n = 1 + static_cast<int>(std::hypot(b[0] - a[0], b[1] - a[1]) / step_mm);
    for (int i = 0; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      points.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2]});
    }
  } else if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
    constexpr double kTurn = 2 * 3.14159265358979323846;
    const Point& c = arc->centre_mm;
    const auto angle = [&c](const Point& p) { return std::atan2(p[1] - c[1], p[0] - c[0]); };
    const double radius = std::hypot(move.start_mm[0] - c[0], move.start_mm[1] - c[1]);
    double sweep = angle(arc->end_mm) - angle(move.start_mm);
    sweep = arc->clockwise ? -sweep : sweep;
    sweep += sweep < 0.0 ? kTurn : 0.0;
    const bool closed = move.start_mm[0] == arc->end_mm[0] && move.start_mm[1] == arc->end_mm[1];
    sweep = (closed ? kTurn : sweep) + kTurn * (arc->turns - 1);
    const int n = 1 + static_cast<int>(sweep * radius / step_mm);
    for (int i = 0; i <= n; ++i) {
      const double at = angle(move.start_mm) + (arc->clockwise ? -sweep : sweep) * i / n;
      points.push_back({c[0] + radius * std::cos(at), c[1] + radius * std::sin(at), c[2]});
    }
  }
  return points;
}

// From the point to the line or arc in XY, by its definition.
inline double distance_mm(const Point& p, const Move& move) {
  if (const auto* line = std::get_if<LineMove>(&move.shape)) {
    const Point& a = move.start_mm;
    const double dx = line->end_mm[0] - a[0];
    const double dy = line->end_mm[1] - a[1];
    const double square = dx * dx + dy * dy;
    const double t = square > 0.0
                         ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0)
                         : 0.0;
    return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
  }
  const auto& arc = std::get<ArcMove>(move.shape);
  constexpr double kTurn = 2 * 3.14159265358979323846;
  const auto angle_to = [&](const Point& q) {
    const double a =
        std::atan2(q[1] - arc.centre_mm[1], q[0] - arc.centre_mm[0]) -
        std::atan2(move.start_mm[1] - arc.centre_mm[1], move.start_mm[0] - arc.centre_mm[0]);
    const double turn = arc.clockwise ? -a : a;
    return turn - kTurn * std::floor(turn / kTurn);
  };
  const bool closed = move.start_mm[0] == arc.end_mm[0] && move.start_mm[1] == arc.end_mm[1];
  const double radius =
      std::hypot(move.start_mm[0] - arc.centre_mm[0], move.start_mm[1] - arc.centre_mm[1]);
  if (closed || arc.turns > 1 || angle_to(p) <= angle_to(arc.end_mm)) {
    return std::fabs(std::hypot(p[0] - arc.centre_mm[0], p[1] - arc.centre_mm[1]) - radius);
  }
  return std::min(std::hypot(p[0] - move.start_mm[0], p[1] - move.start_mm[1]),
                  std::hypot(p[0] - arc.end_mm[0], p[1] - arc.end_mm[1]));
}

// The smallest distance of the tool's centre from the contour, entry and exit left out of both.
inline double clearance_mm(const Contour& contour, const Compensated& result, double step_mm) {
  double least = std::numeric_limits<double>::infinity();
  const std::vector<Move>& programmed = contour.moves();
  for (const Move& way : result.moves) {
    if (way.source.line == 1 || way.source.line == programmed.size()) {
      continue;
    }
    for (const Point& point : samples(way, step_mm)) {
      for (std::size_t i = 1; i + 1 < programmed.size(); ++i) {
        if (!std::holds_alternative<DwellMove>(programmed[i].shape)) {
          least = std::min(least, distance_mm(point, programmed[i]));
        }
      }
    }
  }
  return least;
}

}  // namespace kerf::parser
