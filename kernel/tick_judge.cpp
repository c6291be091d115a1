#include "kernel/tick_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "curves/curve_error.hpp"
#include "parser/moves/auxiliary_axes.hpp"

namespace kerf {

using Figure = TickExcess::Figure;

namespace {

constexpr std::string_view kAxes = "XYZABCUVW";

constexpr double kRelative = 1e-6;
constexpr double kChordRelative = 5e-3;
// Of a position: what curves agree within at their junctions, and four values' rounding.
constexpr double kRounding_mm = 1e-11;
constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();

}  // namespace

std::optional<RunFault> describe(const TickExcess& excess) {
  const std::string where =
      excess.axis == TickExcess::kPath
          ? "along the path"
          : std::string("of axis ") + kAxes[static_cast<std::size_t>(excess.axis)];
  std::string what;
  switch (excess.figure) {
    case Figure::none:
      return std::nullopt;
    case Figure::velocity:
      what = "the velocity " + where;
      break;
    case Figure::acceleration:
      what = "the acceleration " + where;
      break;
    case Figure::jerk:
      what = "the jerk " + where;
      break;
    case Figure::chord_error:
      what = "the chord error";
      break;
    case Figure::end:
      what = "the distance " + where + " from the programmed end";
      break;
    case Figure::not_finite:
      return RunFault{excess.line, "the position " + where + " is not a number at tick " +
                                       std::to_string(excess.tick)};
  }
  return RunFault{excess.line, what + " is " + curves::to_text(excess.found) + ", above " +
                                   curves::to_text(excess.limit) + ", at tick " +
                                   std::to_string(excess.tick)};
}

TickJudge::TickJudge(const Settings& settings)
    : time_{settings.limits.period_s, settings.limits.period_s * settings.limits.period_s,
            settings.limits.period_s * settings.limits.period_s * settings.limits.period_s},
      chord_tolerance_mm_(settings.limits.chord_tolerance_mm),
      binds_jerk_(settings.binds_jerk),
      has_extra_axes_(settings.has_extra_axes) {
  path_.limits = settings.limits.path;
  std::int8_t number = 0;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    axes_[k].limits = settings.limits.axes[k];
    axes_[k].axis = number++;
  }
  for (std::size_t k = 0; k < extra_.size(); ++k) {
    extra_[k].limits = settings.limits.extra[k];
    extra_[k].axis = number++;
  }
}

std::array<Peaks, 3> TickJudge::axes() const noexcept {
  std::array<Peaks, 3> peaks;
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    peaks[k] = peaks_of(axes_[k]);
  }
  return peaks;
}

std::array<Peaks, curves::kAuxiliaryAxes> TickJudge::extra_axes() const noexcept {
  std::array<Peaks, curves::kAuxiliaryAxes> peaks;
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    peaks[k] = peaks_of(extra_[k]);
  }
  return peaks;
}

// Only a new peak can be an excess, so most ticks compare three differences and no more. What is no
// number fails the comparison, too.
inline void TickJudge::add(Track& track, double x, const interp::Setpoint& at) noexcept {
  auto& [x1, x2, x3] = track.x;
  const double first = std::abs(x - x1);
  const double second = std::abs(x - 2.0 * x1 + x2);
  const double third = std::abs(x - 3.0 * (x1 - x2) - x3);
  const bool rises = !(first <= track.most[0] && second <= track.most[1] && third <= track.most[2]);
  if (rises && settling_ == 0) {
    raise(track, {.x = x, .differences = {first, second, third}}, at);
  }
  x3 = x2;
  x2 = x1;
  x1 = x;
}

void TickJudge::add(const interp::Setpoint& setpoint, double chord_error_mm) noexcept {
  if (!began_) {
    path_.x.fill(setpoint.s_mm);
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      axes_[k].x.fill(setpoint.position_mm[k]);
    }
    for (std::size_t k = 0; k < extra_.size(); ++k) {
      extra_[k].x.fill(setpoint.extra_rad_mm[k]);
    }
    began_ = true;
  }
  add(path_, setpoint.s_mm, setpoint);
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    add(axes_[k], setpoint.position_mm[k], setpoint);
  }
  for (std::size_t k = 0; k < extra_.size() && has_extra_axes_; ++k) {
    add(extra_[k], setpoint.extra_rad_mm[k], setpoint);
  }
  settling_ = std::max(settling_ - 1, 0);
  latest_chord_error_mm_ = chord_error_mm;
  if (chord_error_mm > chord_error_mm_) {
    chord_error_mm_ = chord_error_mm;
    judge({.figure = Figure::chord_error,
           .line = setpoint.line,
           .tick = setpoint.tick,
           .found = chord_error_mm,
           .limit = chord_tolerance_mm_ * (1.0 + kChordRelative)},
          kRounding_mm);
  }
}

void TickJudge::judge_end(const interp::Setpoint& last, const PlaceOfTool& programmed) noexcept {
  TickExcess found{.figure = Figure::end,
                   .line = last.line,
                   .tick = last.tick,
                   .limit = parser::kShortestWay_mm};
  for (std::size_t k = 0; k < axes_.size() + extra_.size(); ++k) {
    const std::size_t e = k - std::min(k, axes_.size());
    const bool extra = k >= axes_.size();
    const double is = extra ? last.extra_rad_mm[e] : last.position_mm[k];
    found.found = std::abs(is - (extra ? programmed.extra_rad_mm[e] : programmed.position_mm[k]));
    found.axis = static_cast<std::int8_t>(k);
    judge(found, kRounding_mm + kRounding * std::abs(is));
  }
}

void TickJudge::raise(Track& track, const Tick& now, const interp::Setpoint& at) noexcept {
  constexpr std::array kFigures{Figure::velocity, Figure::acceleration, Figure::jerk};
  TickExcess found{
      .figure = Figure::not_finite, .axis = track.axis, .line = at.line, .tick = at.tick};
  if (!std::isfinite(now.x)) {
    judge(found, 0.0);
    return;
  }
  const std::array<double, 3> limits{track.limits.velocity_mm_s, track.limits.acceleration_mm_s2,
                                     track.limits.jerk_mm_s3};
  const double rounding = kRounding_mm + kRounding * std::abs(now.x);
  for (std::size_t k = 0; k < kFigures.size(); ++k) {
    if (!(now.differences[k] > track.most[k])) {
      continue;
    }
    track.most[k] = now.differences[k];
    if (kFigures[k] == Figure::jerk && !binds_jerk_) {
      continue;
    }
    const double per = time_[k];
    found.figure = kFigures[k];
    found.found = now.differences[k] / per;
    found.limit = limits[k] * (1.0 + kRelative);
    judge(found, rounding / per);
  }
}

Peaks TickJudge::peaks_of(const Track& track) const noexcept {
  return {.v_mm_s = track.most[0] / time_[0],
          .a_mm_s2 = track.most[1] / time_[1],
          .j_mm_s3 = track.most[2] / time_[2]};
}

void TickJudge::judge(const TickExcess& found, double rounding) noexcept {
  const bool holds = found.figure != Figure::not_finite && found.found <= found.limit + rounding;
  if (!holds && excess_.figure == Figure::none) {
    excess_ = found;
  }
}

}  // namespace kerf
