#include "lookahead/optimum/grid/independent_line.hpp"

#include <algorithm>
#include <variant>

#include "profiles/profile.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kRise = 1.2;  // of the feedrate between junctions over the faster of them

}  // namespace

bool is_independent_line(const Block& block, const LineJunctions& junctions) {
  static const profiles::Profile kFastest(profiles::ProfileKind::s_curve);
  if (!std::holds_alternative<curves::Line>(block.curve)) {
    return false;
  }
  const double highest_mm_s = std::max(junctions.begin.feedrate_mm_s, junctions.end.feedrate_mm_s);
  const double peak_mm_s = junctions.are_cruises
                               ? highest_mm_s
                               : std::min(block.limits.feedrate_mm_s, kRise * highest_mm_s);
  double way_mm = 0.0;
  for (const Junction* junction : {&junctions.begin, &junctions.end}) {
    way_mm += junction->constant_velocity_s * junction->feedrate_mm_s +
              kFastest.length_mm({junction->feedrate_mm_s, peak_mm_s}, block.limits.ramp);
  }
  return way_mm <= block.length_mm;
}

void LinesAhead::clear() {
  lines_.clear();
  fall_ = 0.0;
}

void LinesAhead::push(const Block& line, double v_begin_mm_s) {
  const profiles::RampLimits& ramp = line.limits.ramp;
  const double fall = std::min(0.75 * ramp.jerk_mm_s3 * line.length_mm * line.length_mm,
                               1.5 * ramp.acceleration_mm_s2 * line.length_mm * v_begin_mm_s);
  lines_.push_back({.v_begin_mm_s = v_begin_mm_s, .fall = fall});
  fall_ += fall;
  if (lines_.size() > most_) {
    fall_ -= lines_.front().fall;
    lines_.pop_front();
  }
}

bool LinesAhead::are_long_enough() const {
  if (lines_.size() < most_) {
    return true;
  }
  const double v = lines_.front().v_begin_mm_s;
  return fall_ >= v * v * v;
}

}  // namespace kerf::lookahead
