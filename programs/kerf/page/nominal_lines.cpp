#include "programs/kerf/page/nominal_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "curves/curve.hpp"

namespace kerf::program {

double NominalLines::nominal_s(const smoothing::PathSegment& segment) const {
  const double length_mm = curves::length_mm(segment.curve);
  double duration_s = 0.0;
  if (!segment.rapid && segment.feedrate_mm_s > 0.0) {
    const double followed = segment.follows.feed ? feed_override_ : 1.0;
    duration_s = length_mm / (followed * segment.feedrate_mm_s);
  }
  if (!segment.extra.alone) {
    duration_s = std::max(duration_s, length_mm / limits_.path.velocity_mm_s);
    const auto begin_mm = curves::position_at(segment.curve, 0.0);
    const auto end_mm = curves::position_at(segment.curve, length_mm);
    for (std::size_t k = 0; k < limits_.axes.size(); ++k) {
      const double way_mm = std::abs(end_mm[k] - begin_mm[k]);
      duration_s = std::max(duration_s, way_mm / limits_.axes[k].velocity_mm_s);
    }
  }
  for (std::size_t k = 0; k < limits_.extra.size(); ++k) {
    const double way = std::abs(segment.extra.end_rad_mm[k] - segment.extra.begin_rad_mm[k]);
    duration_s = std::max(duration_s, way / limits_.extra[k].velocity_mm_s);
  }
  return duration_s;
}

void NominalLines::add(const smoothing::PathSegment& segment) {
  const double duration_s = nominal_s(segment);
  const double length_mm = curves::length_mm(segment.curve);
  const double begin_mm = path_mm_;
  const double on_path = segment.extra.alone ? 0.0 : 1.0;
  for (std::size_t i = 0; i < segment.marks.size(); ++i) {
    const auto& [s_mm, line, run_block] = segment.marks[i];
    const double end_mm = i + 1 < segment.marks.size() ? segment.marks[i + 1].s_mm : length_mm;
    path_mm_ = begin_mm + on_path * end_mm;
    count(line, duration_s * (end_mm - s_mm) / length_mm);
  }
  path_mm_ = begin_mm + on_path * length_mm;
  if (segment.marks.empty()) {
    count(segment.source.program_line(), duration_s);
  }
}

void NominalLines::add(const parser::Move& move) {
  if (const auto* dwell = std::get_if<parser::DwellMove>(&move.shape)) {
    count(move.source.program_line(), dwell->duration_s);
  } else if (const auto* event = std::get_if<parser::EventMove>(&move.shape)) {
    if (const double duration_s = events_.next_s(*event); duration_s > 0.0) {
      count(move.source.program_line(), duration_s);
    }
  }
}

void NominalLines::count(std::uint32_t line, double duration_s) {
  if (line >= lines_.size()) {
    lines_.resize(std::size_t{line} + 1);
  }
  lines_[line].duration_s += duration_s;
  lines_[line].end_mm = path_mm_;
}

}  // namespace kerf::program
