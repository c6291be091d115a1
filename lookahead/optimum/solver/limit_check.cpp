#include "lookahead/optimum/solver/limit_check.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "profiles/cell_law.hpp"

namespace kerf::lookahead {

namespace {

// Of a cell between two places, at the least; a part turns by no more than this angle.
constexpr int kParts = 5;
constexpr double kAngle = 0.02;
constexpr int kMaxParts = 40;
constexpr double kBeside = 0.02;  // of a part: so near the cell's ends is it looked at, too

// In a cell, counted from its begin.
struct Place {
  double share = 0.0;  // of its length or of its time: 0 and 1 are its ends
  double s_mm = 0.0;
};

// The ends from within the cell: derivatives may jump there.
PathSample path_in(const Cell& cell, const Place& place, const PathAt& path) {
  if (place.share == 0.0 || place.share == 1.0) {
    return place.share == 0.0 ? cell.begin : cell.end;
  }
  PathSample inside = path(cell, cell.s_begin_mm + place.s_mm);
  inside.bind_feedrate(cell.sub_tick_mm_s, Constraint::chord_error);
  return inside;
}

// What is not a number is beyond every limit.
void grow(double& worst, double share) {
  if (!(share <= worst)) {
    worst = std::isnan(share) ? kUnbounded : share;
  }
}

// What was found at a place, to be joined with the next one.
struct Seen {
  double s_mm = 0.0;
  double v_mm_s = 0.0;
  curves::Position velocity_mm_s{};  // of each axis
  curves::Position acceleration_mm_s2{};
  curves::Position jerk_mm_s3{};
};

Seen look_at(const profiles::PathMotion& motion, const Cell& cell, const PathSample& path,
             const PlanLimits& limits, Excess& worst) {
  grow(worst.feedrate, motion.v_mm_s / path.feedrate_mm_s);
  grow(worst.acceleration,
       std::abs(motion.a_mm_s2) / (cell.allowed.acceleration * cell.along.acceleration_mm_s2));
  grow(worst.jerk, std::abs(motion.j_mm_s3) / (cell.allowed.jerk * cell.along.jerk_mm_s3));
  Seen seen{.s_mm = motion.s_mm, .v_mm_s = motion.v_mm_s};
  for (std::size_t k = 0; k < 3; ++k) {
    const AxisTerms terms = axis_terms(path, k, motion);
    seen.velocity_mm_s[k] = path.first[k] * motion.v_mm_s;
    seen.acceleration_mm_s2[k] = terms.acceleration_mm_s2();
    seen.jerk_mm_s3[k] = terms.jerk_mm_s3();
    grow(worst.acceleration, std::abs(seen.acceleration_mm_s2[k]) /
                                 (cell.allowed.acceleration * limits.axes[k].acceleration_mm_s2));
    grow(worst.jerk,
         (std::abs(seen.jerk_mm_s3[k]) + cell.jumps_per_mm_s[k] * motion.v_mm_s * motion.v_mm_s) /
             (cell.allowed.jerk * limits.axes[k].jerk_mm_s3));
  }
  return seen;
}

// What rises at one place and falls at the next has a peak between them; its slope is taken as
// linear in time there. Nothing: it has none.
struct Slopes {
  double before = 0.0;
  double after = 0.0;
};
std::optional<double> peak_between(double value, const Slopes& slopes, double time_s) {
  const double rise = std::copysign(slopes.before, value * slopes.before);
  const double fall = -std::copysign(slopes.after, value * slopes.after);
  if (rise > 0.0 && fall > 0.0) {
    return std::abs(value) + 0.5 * time_s * rise * rise / (rise + fall);
  }
  return std::nullopt;
}

// Of an axis' velocity and acceleration.
void look_between(const Seen& before, const Seen& after, const Cell& cell, const PlanLimits& limits,
                  Excess& worst) {
  const double time = 2.0 * (after.s_mm - before.s_mm) / (before.v_mm_s + after.v_mm_s);
  for (std::size_t k = 0; k < 3; ++k) {
    if (const auto peak =
            peak_between(before.velocity_mm_s[k],
                         {before.acceleration_mm_s2[k], after.acceleration_mm_s2[k]}, time)) {
      grow(worst.feedrate, *peak / limits.axes[k].velocity_mm_s);
    }
    if (const auto peak = peak_between(before.acceleration_mm_s2[k],
                                       {before.jerk_mm_s3[k], after.jerk_mm_s3[k]}, time)) {
      grow(worst.acceleration,
           *peak / (cell.allowed.acceleration * limits.axes[k].acceleration_mm_s2));
    }
  }
}

// The fourth derivative of a curve jumps at its knots, and with it the slope of an axis' jerk: the
// peak between the inner two of four places is where the lines through the outer ones meet.
void look_at_kink(const std::array<Seen, 4>& seen, const Cell& cell, const PlanLimits& limits,
                  Excess& worst) {
  const double way = seen[2].s_mm - seen[1].s_mm;
  for (std::size_t k = 0; k < 3; ++k) {
    const double sign = std::copysign(1.0, seen[1].jerk_mm_s3[k]);
    const auto jerk = [&](std::size_t i) { return sign * seen[i].jerk_mm_s3[k]; };
    const double rise = (jerk(1) - jerk(0)) / (seen[1].s_mm - seen[0].s_mm);
    const double fall = (jerk(2) - jerk(3)) / (seen[3].s_mm - seen[2].s_mm);
    const double place = (jerk(2) - jerk(1) + fall * way) / (rise + fall);
    if (rise > 0.0 && fall > 0.0 && place > 0.0 && place < way) {
      const double jumps = cell.jumps_per_mm_s[k] * seen[1].v_mm_s * seen[1].v_mm_s;
      grow(worst.jerk,
           (jerk(1) + rise * place + jumps) / (cell.allowed.jerk * limits.axes[k].jerk_mm_s3));
    }
  }
}

}  // namespace

double Excess::largest() const noexcept {
  return std::max({feedrate, acceleration, jerk});
}

Excess excess_of(const Cell& cell, const SquaredFeed& begin, const PathAt& path,
                 const PlanLimits& limits) {
  assert(cell.length_mm > 0.0);
  Excess worst;
  const auto look = [&](double place) {
    const double s = place * cell.length_mm;
    const double slope = begin.slope + begin.bend * s;
    const double b = begin.value + s * (begin.slope + 0.5 * begin.bend * s);
    const double v = std::sqrt(std::max(b, 0.0));
    return look_at(
        {.s_mm = s, .v_mm_s = v, .a_mm_s2 = 0.5 * slope, .j_mm_s3 = 0.5 * v * begin.bend}, cell,
        path_in(cell, {place, s}, path), limits, worst);
  };
  const double peak = -begin.slope / (begin.bend * cell.length_mm);  // of the feedrate
  const bool has_peak = begin.bend < 0.0 && peak > 0.0 && peak < 1.0;
  // On a line each axis has its share of the path's motion: its acceleration is linear over the
  // cell, its jerk goes with the feedrate.
  if (cell.straight && !has_peak) {
    look(0.0);
    look(1.0);
    return worst;
  }
  const double curvature = std::max(curves::vec(cell.begin.second_per_mm).norm(),
                                    curves::vec(cell.end.second_per_mm).norm());
  const double parts =
      std::clamp(std::ceil(curvature * cell.length_mm / kAngle), 1.0 * kParts, 1.0 * kMaxParts);
  std::array<Seen, 4> seen{};  // the newest last
  seen[3] = look(0.0);
  int count = 1;
  const auto go_on_to = [&](double place) {
    std::rotate(seen.begin(), seen.begin() + 1, seen.end());
    seen[3] = look(place);
    look_between(seen[2], seen[3], cell, limits, worst);
    if (++count >= 4) {
      look_at_kink(seen, cell, limits, worst);
    }
  };
  go_on_to(kBeside / parts);
  for (int i = 1; i < static_cast<int>(parts); ++i) {
    go_on_to(i / parts);
  }
  go_on_to(1.0 - kBeside / parts);
  go_on_to(1.0);
  if (has_peak) {
    look(peak);
  }
  return worst;
}

Excess excess_at(const profiles::PathMotion& motion, const Cell& cell, const PathAt& path,
                 const PlanLimits& limits) {
  Excess found;
  look_at(motion, cell, path_in(cell, {motion.s_mm / cell.length_mm, motion.s_mm}, path), limits,
          found);
  return found;
}

Excess excess_of_rest(const Cell& cell, double v_mm_s, bool launch, const PathAt& path,
                      const PlanLimits& limits) {
  const profiles::CellLaw law = launch ? profiles::CellLaw::launch(v_mm_s, cell.length_mm)
                                       : profiles::CellLaw::landing(v_mm_s, cell.length_mm);
  Excess worst;
  for (int i = 0; i <= kParts; ++i) {
    const double place = static_cast<double>(i) / kParts;
    const profiles::PathMotion motion = law.at(place * law.duration_s());
    look_at(motion, cell, path_in(cell, {place, motion.s_mm}, path), limits, worst);
  }
  return worst;
}

}  // namespace kerf::lookahead
