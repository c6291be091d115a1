#include <algorithm>
#include <optional>

#include "lookahead/classical/acceleration_ramp.hpp"

namespace kerf::lookahead {

namespace {

// What fits may miss by rounding.
constexpr double kWithRounding = 1.0 + 1e-9;
// Fewer where curvature binds: each ramp is a search of its own there.
constexpr int kCurvatureHalvings = 12;
// Where only a tiny share of the cap fits, on and on until as close as this.
constexpr double kClose = 1e-3;
constexpr int kMaxHalvings = 200;
constexpr int kCurvatureSteps = 8;
// Of its feedrate: within so narrow a bracket, where curvature binds, the ramps' margins are worth
// more time than the best cruise.
constexpr double kNarrow = 0.005;
constexpr double kGolden = 0.6180339887498949;

}  // namespace

Cruise CruiseSearch::best() const {
  const double low = std::max(ends_.v_begin_mm_s, ends_.v_end_mm_s);
  double high = std::max(low, std::min({segment_.limits.feedrate_mm_s, segment_.rise.top_mm_s(),
                                        segment_.fall.top_mm_s()}));
  std::optional<Cruise> highest = fitting(high);
  if (!highest) {
    double fits = low;
    const int halvings = segment_.axis_limits.empty() ? 40 : kCurvatureHalvings;
    for (int i = 0; i < halvings || (high - fits > kClose * high && i < kMaxHalvings); ++i) {
      const double middle = 0.5 * (fits + high);
      if (const auto cruise = fitting(middle)) {
        fits = middle;
        highest = cruise;
      } else {
        high = middle;
      }
    }
  }
  return fastest_below(highest ? *highest : cruise_at(low), low);
}

RampRequest CruiseSearch::side(SegmentSide side, double v_mm_s) const {
  const double v_foot_mm_s = side == SegmentSide::rise ? ends_.v_begin_mm_s : ends_.v_end_mm_s;
  return {.side = side,
          .ramp = {v_foot_mm_s, v_mm_s},
          .room_mm = kWithRounding * length_mm_,
          .may_wait = true};
}

Cruise CruiseSearch::cruise_at(double v_mm_s) const {
  return {.v_mm_s = v_mm_s,
          .up = acceleration_ramp(side(SegmentSide::rise, v_mm_s), segment_, profile_),
          .down_mirrored = acceleration_ramp(side(SegmentSide::fall, v_mm_s), segment_, profile_)};
}

std::optional<Cruise> CruiseSearch::fitting(double v_mm_s) const {
  const RampRequest up = side(SegmentSide::rise, v_mm_s);
  const RampRequest down = side(SegmentSide::fall, v_mm_s);
  const double room_mm = kWithRounding * length_mm_;
  const double least_down_mm = least_length_mm(down, segment_, profile_);
  if (least_length_mm(up, segment_, profile_) + least_down_mm > room_mm) {
    return std::nullopt;
  }
  Cruise cruise{.v_mm_s = v_mm_s, .up = acceleration_ramp(up, segment_, profile_)};
  if (cruise.up.length_mm() + least_down_mm > room_mm) {
    return std::nullopt;
  }
  cruise.down_mirrored = acceleration_ramp(down, segment_, profile_);
  return spare_mm(cruise) >= 0.0 ? std::optional(cruise) : std::nullopt;
}

double CruiseSearch::spare_mm(const Cruise& cruise) const {
  return length_mm_ - cruise.up.length_mm() - cruise.down_mirrored.length_mm();
}

double CruiseSearch::time_s(const Cruise& cruise) const {
  if (!segment_.axis_limits.empty() && spare_mm(cruise) < 0.0) {
    return kUnbounded;
  }
  return cruise.up.duration_s() + cruise.down_mirrored.duration_s() +
         spare_mm(cruise) / cruise.v_mm_s;
}

CruiseSearch::Timed CruiseSearch::timed(double v_mm_s) const {
  const Cruise cruise = cruise_at(v_mm_s);
  return {.cruise = cruise, .time_s = time_s(cruise)};
}

Cruise CruiseSearch::fastest_below(const Cruise& highest, double low_mm_s) const {
  double a = low_mm_s;
  double b = highest.v_mm_s;
  const bool binds = !segment_.axis_limits.empty();
  const auto is_narrow = [&] { return b - a <= (binds ? kNarrow * b : 0.0); };
  if (is_narrow()) {
    return highest;
  }
  double x1 = b - kGolden * (b - a);
  double x2 = a + kGolden * (b - a);
  Timed at1 = timed(x1);
  Timed at2 = timed(x2);
  for (int i = 0; i < (binds ? kCurvatureSteps : 24) && !is_narrow(); ++i) {
    if (at1.time_s < at2.time_s) {
      b = x2;
      x2 = x1;
      at2 = at1;
      x1 = b - kGolden * (b - a);
      at1 = timed(x1);
    } else {
      a = x1;
      x1 = x2;
      at1 = at2;
      x2 = a + kGolden * (b - a);
      at2 = timed(x2);
    }
  }
  const Timed& inner = at1.time_s < at2.time_s ? at1 : at2;
  return time_s(highest) <= inner.time_s ? highest : inner.cruise;
}

}  // namespace kerf::lookahead
