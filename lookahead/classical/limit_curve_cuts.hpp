// Where the velocity limit curve is cut into segments: at valleys, and where a ramp would crawl.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/classical/slope.hpp"
#include "lookahead/path/path_sample.hpp"

namespace kerf::lookahead {

// Indices of the breaking points of a scan, first and last sample included, in two steps
// [Sigmoid, section 3.2], docs/math.md, 6.1:
// 1. screening: the slope of v over u changes by more than screening_mm_s between two samples;
// 2. of these candidates those stay where v stops rising or falling.
std::vector<std::size_t> breaking_points(const VelocityLimitCurve& limit_curve,
                                         double screening_mm_s);

// The breaking points that are valleys: the lowest between two places that are both higher by more
// than noise, a share of the feedrate.
std::vector<std::size_t> valleys(const VelocityLimitCurve& limit_curve,
                                 const std::vector<std::size_t>& breaking, double noise = 0.01);

// The samples at which the ramp from the foot (its slower end) is cut, ascending; none where one
// ramp of one acceleration takes no more than twice the time of the fastest ramp.
//
//      v^2            . top         A ramp of one acceleration is a straight line over s in v^2.
//       |         _.-'              No motion is faster than the lower convex hull of the limit
//       |      .-'    /             curve; each side of it has an acceleration of its own. Where
//       |   .-'     /               the foot stands in a feature of some nanometres, the first
//       |.-'      / one ramp        side is so flat that a ramp that goes on with it would crawl
//       |       /                   for the whole length of the segment; a cut after it costs one
//       |  |_./                     instant without acceleration.
//       +---------------- s
//
// The hull is thinned where its sides differ little; of its corners the one that leaves the least
// time in both parts is cut at, then each part again. Of the jerk only this is taken into account:
// a place of the limit curve that it keeps out of reach from the foot does not count. Samples:
// distance from 0, ascending, their feedrate not below 0; the ramp begins with that of the first.
// The jerk may be infinite.
std::vector<std::size_t> ramp_cuts(const std::vector<Slope::Sample>& samples,
                                   const profiles::RampLimits& limits);

// A range of samples, both ends included.
struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

// The samples from the range's begin up to the highest, and from its end down to there, each with
// the distance from where it begins.
struct Hill {
  std::vector<Slope::Sample> rise;
  std::vector<Slope::Sample> fall;
};

Hill hill_of(const VelocityLimitCurve& limit_curve, const SampleRange& range);

struct Cutting {
  double noise = 0.0;  // dips and humps of less than this share of the feedrate do not count
  double period_s = 0.0;
  profiles::RampLimits ramp{};  // no ramp is steeper
};

struct CutLimitCurve {
  VelocityLimitCurve limit_curve;
  std::vector<std::size_t> cuts;  // samples, ascending; the last one's is the end
};

// The limit curve, cut at its valleys and where a ramp from one would crawl (ramp_cuts). It gets
// more samples where feedrates of neighbours are far apart. Valleys within a tick's distance count
// as one, and between them it gets the feedrate of the lowest. Precondition: two samples at least.
CutLimitCurve cut(const VelocityLimitCurve& scanned, const Cutting& how);

}  // namespace kerf::lookahead
