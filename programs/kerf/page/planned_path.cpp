#include "programs/kerf/page/planned_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "curves/curve.hpp"

namespace kerf::program {

namespace {

// Points on what is no line: so many for each length of the whole path's size, and at most.
constexpr double kPointsOfSize = 5000.0;
constexpr double kMostPoints = 20'000.0;
constexpr double kNm_mm = 1e-6;

int points_on(const curves::Curve& curve, double share_of_size) {
  if (std::holds_alternative<curves::Line>(curve)) {
    return 1;
  }
  return static_cast<int>(std::clamp(std::ceil(kPointsOfSize * share_of_size), 8.0, kMostPoints));
}

}  // namespace

double size_mm(const curves::Extents& extents) {
  double size_mm = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    size_mm = std::max(size_mm, extents.max_mm[k] - extents.min_mm[k]);
  }
  return size_mm;
}

double drawn_tolerance_mm(const curves::Extents& extents) {
  constexpr double kShareOfSize = 1e-6;
  constexpr double kFinest_mm = 1e-6;
  return std::max(kShareOfSize * size_mm(extents), kFinest_mm);
}

PlannedPath::PlannedPath(const curves::Extents& extents)
    : size_mm_(std::max(size_mm(extents), kNm_mm)),
      outline_({.tolerance_mm = drawn_tolerance_mm(extents)}) {}

void PlannedPath::add(const smoothing::PathSegment& segment) {
  const double length_mm = curves::length_mm(segment.curve);
  enter(segment.source.file, segment.source.line);
  for (const smoothing::LineMark& mark : segment.marks) {
    enter(segment.source.file, mark.line);
  }
  add_step({.end_mm = length_mm_ + length_mm, .deviation_mm = segment.deviation_mm});
  const int points = points_on(segment.curve, length_mm / size_mm_);
  for (int i = 0; i <= points; ++i) {
    const double s_mm = length_mm * i / points;
    add_point({.tick = std::llround((length_mm_ + s_mm) / kNm_mm),
               .position_mm = curves::position_at(segment.curve, s_mm),
               .rapid = segment.rapid});
  }
  length_mm_ += length_mm;
}

void PlannedPath::enter(std::uint16_t file, std::uint32_t line) {
  if (!parts_.empty() && parts_.back().file == file) {
    Part& part = parts_.back();
    part.first_line = std::min(part.first_line, line);
    part.last_line = std::max(part.last_line, line);
  } else if (parts_.size() < kMaxSteps) {
    parts_.push_back({.begin_mm = length_mm_, .file = file, .first_line = line, .last_line = line});
  }
}

void PlannedPath::add_point(const TimedPoint& point) {
  if (point.tick > last_tick_) {
    last_tick_ = point.tick;
    outline_.add(point);
  }
}

void PlannedPath::add_step(const Step& step) {
  if (!steps_.empty() && steps_.back().deviation_mm == step.deviation_mm) {
    steps_.back().end_mm = step.end_mm;
    return;
  }
  if (steps_.size() == kMaxSteps) {
    for (std::size_t i = 0; i < kMaxSteps / 2; ++i) {
      const Step& last = steps_[2 * i + 1];
      steps_[i] = {.end_mm = last.end_mm,
                   .deviation_mm = std::max(steps_[2 * i].deviation_mm, last.deviation_mm)};
    }
    steps_.resize(kMaxSteps / 2);
  }
  steps_.push_back(step);
}

double DeviationAlong::advance_to(double s_mm) {
  if (path_ == nullptr || path_->deviations().empty()) {
    return 0.0;
  }
  const std::vector<PlannedPath::Step>& steps = path_->deviations();
  double largest_mm = steps[step_].deviation_mm;
  while (step_ + 1 < steps.size() && steps[step_].end_mm < s_mm) {
    ++step_;
    largest_mm = std::max(largest_mm, steps[step_].deviation_mm);
  }
  return largest_mm;
}

// Where two files meet the line tells which of them a rest belongs to.
std::uint16_t FileAlong::advance_to(double s_mm, std::uint32_t line) {
  if (path_ == nullptr || path_->parts().empty()) {
    return 0;
  }
  constexpr double kJoint_mm = 1e-6;
  const std::vector<PlannedPath::Part>& parts = path_->parts();
  while (part_ + 1 < parts.size()) {
    const double way_mm = s_mm - parts[part_ + 1].begin_mm;
    if (way_mm < -kJoint_mm || (way_mm <= kJoint_mm && parts[part_].has(line))) {
      break;
    }
    ++part_;
  }
  return parts[part_].file;
}

}  // namespace kerf::program
