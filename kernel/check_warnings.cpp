#include "kernel/check_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "diagnostics/errors/pages.hpp"
#include "lookahead/path/limits.hpp"
#include "parser/text/text.hpp"

namespace kerf {

namespace {

constexpr double kSecondsPerMinute = 60.0;
constexpr std::size_t kLongestLoop = 128;  // lines
constexpr std::size_t kShortestLoop = 3;   // two lead there and back, which smoothing leaves alone

double reach_of(const lookahead::PlanLimits& limits) {
  double squares = 0.0;
  for (const lookahead::MotionLimits& axis : limits.axes) {
    squares += axis.velocity_mm_s * axis.velocity_mm_s;
  }
  return std::min(limits.path.velocity_mm_s, std::sqrt(squares));
}

double distance_mm(const parser::Point& a, const parser::Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The highest feedrate along a line, where each axis takes its share of it.
double reach_along(const lookahead::PlanLimits& limits, const parser::Point& from_mm,
                   const parser::Point& to_mm) {
  const double length_mm = distance_mm(from_mm, to_mm);
  double reach_mm_s = limits.path.velocity_mm_s;
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    const double step_mm = std::abs(to_mm[k] - from_mm[k]);
    if (step_mm > 0.0) {
      reach_mm_s = std::min(reach_mm_s, limits.axes[k].velocity_mm_s * (length_mm / step_mm));
    }
  }
  return reach_mm_s;
}

}  // namespace

void CheckWarnings::Box::include(const parser::Point& point_mm) {
  for (std::size_t k = 0; k < 3; ++k) {
    min_mm[k] = std::min(min_mm[k], point_mm[k]);
    max_mm[k] = std::max(max_mm[k], point_mm[k]);
  }
}

double CheckWarnings::Box::size_mm() const {
  return std::max({max_mm[0] - min_mm[0], max_mm[1] - min_mm[1], max_mm[2] - min_mm[2]});
}

CheckWarnings::CheckWarnings(const lookahead::PlanLimits& limits)
    : limits_(limits), reach_mm_s_(reach_of(limits)) {}

void CheckWarnings::look_at(const parser::Move& move, std::vector<diagnostics::Diagnostic>& found) {
  constexpr std::size_t kMotions = 3;  // lines, arcs and splines come first
  if (move.shape.index() < kMotions && !move.rapid && !move.auxiliary.moves()) {
    check_feed(move, found);
  }
  const bool goes_on = lines_ > 0 && move.blend_tolerance_mm == tolerance_mm_ &&
                       move.merge_tolerance_mm == merge_mm_;
  const bool taken = move.mode == parser::PathMode::blend && !move.rapid &&
                     !move.auxiliary.moves() &&
                     std::holds_alternative<parser::LineMove>(move.shape);
  if (!taken || !goes_on) {
    end_run(found);
  }
  if (taken) {
    take_line(move, found);
  }
}

// The machine's limits hold all the same, so it is enough to say it of the first. Of a curve it is
// said where no direction has the feedrate.
void CheckWarnings::check_feed(const parser::Move& move,
                               std::vector<diagnostics::Diagnostic>& found) {
  if (feed_told_) {
    return;
  }
  const auto* const line = std::get_if<parser::LineMove>(&move.shape);
  const double reach_mm_s =
      line != nullptr ? reach_along(limits_, move.start_mm, line->end_mm) : reach_mm_s_;
  if (!(move.feedrate_mm_s > reach_mm_s * (1.0 + 1e-9))) {
    return;
  }
  feed_told_ = true;
  const auto per_min = [](double feed_mm_s) {  // without the noise of the two changes of unit
    constexpr double kParts = 1e6;
    return parser::shortest(std::round(feed_mm_s * kSecondsPerMinute * kParts) / kParts);
  };
  found.emplace_back(
      move.source, errors::kFeedBeyondReach,
      parser::joined({"a feed of ", per_min(move.feedrate_mm_s), " mm/min: the machine reaches ",
                      per_min(reach_mm_s), " mm/min at the most, ",
                      line != nullptr ? "along this line" : "whatever the direction"}));
}

// Where a loop began that ends here and is nowhere larger than the tolerance; null: none.
const CheckWarnings::Vertex* CheckWarnings::loop_to(const parser::Point& end_mm,
                                                    double tolerance_mm) const {
  constexpr double kClosed = 1e-3;  // of the tolerance
  Box box{end_mm, end_mm};
  for (std::size_t back = 1; back <= vertices_.size(); ++back) {
    const Vertex& vertex = vertices_[vertices_.size() - back];
    box.include(vertex.place_mm);
    if (box.size_mm() > tolerance_mm) {
      return nullptr;
    }
    if (back >= kShortestLoop && distance_mm(vertex.place_mm, end_mm) <= kClosed * tolerance_mm) {
      return &vertex;
    }
  }
  return nullptr;
}

bool CheckWarnings::is_told(double tolerance_mm) const {
  constexpr std::size_t kMax = 20;
  return told_mm_.size() == kMax ||
         std::find(told_mm_.begin(), told_mm_.end(), tolerance_mm) != told_mm_.end();
}

void CheckWarnings::take_line(const parser::Move& move,
                              std::vector<diagnostics::Diagnostic>& found) {
  const parser::Point& end_mm = std::get<parser::LineMove>(move.shape).end_mm;
  if (lines_ == 0) {
    box_ = {move.start_mm, move.start_mm};
    run_begin_ = move.source;
    tolerance_mm_ = move.blend_tolerance_mm;
    merge_mm_ = move.merge_tolerance_mm;
  }
  ++lines_;
  box_.include(end_mm);
  vertices_.push_back({move.start_mm, move.source});
  if (vertices_.size() > kLongestLoop) {
    vertices_.pop_front();
  }
  if (is_told(merge_mm_)) {
    return;
  }
  if (const Vertex* const begin = loop_to(end_mm, merge_mm_)) {
    told_mm_.push_back(merge_mm_);
    found.emplace_back(
        begin->source, errors::kToleranceSwallows,
        parser::joined(
            {"G64: a closed loop begins here that is nowhere larger than the tolerance (",
             parser::shortest(merge_mm_), " mm): it may vanish"}));
  }
}

void CheckWarnings::end_run(std::vector<diagnostics::Diagnostic>& found) {
  const double tolerance_mm = std::max(tolerance_mm_, merge_mm_);
  if (lines_ > 1 && !is_told(tolerance_mm) && box_.size_mm() <= tolerance_mm) {
    told_mm_.push_back(tolerance_mm);
    found.emplace_back(
        run_begin_, errors::kToleranceSwallows,
        parser::joined({"G64: the ", std::to_string(lines_), " lines from here on lie within ",
                        parser::shortest(box_.size_mm()), " mm, and the tolerance is ",
                        parser::shortest(tolerance_mm), " mm: little of their shape is left"}));
  }
  lines_ = 0;
  vertices_.clear();
}

}  // namespace kerf
