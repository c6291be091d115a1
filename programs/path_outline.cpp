#include "programs/path_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace kerf::program {

namespace {

// Doubling must get somewhere.
constexpr double kLeastTolerance = 1e-9;

}  // namespace

PathOutline::PathOutline(const OutlineTolerance& tolerance, std::size_t max_points)
    : tolerance_{.distance_mm = std::max(tolerance.distance_mm, kLeastTolerance),
                 .v_share = std::max(tolerance.v_share, kLeastTolerance)},
      max_points_(max_points) {}

bool PathOutline::extend_stretch(const OutlinePoint& point) {
  const OutlinePoint& from = kept_.back();
  if (point.rapid != from.rapid) {
    return false;
  }
  if (!point.rapid) {
    max_v_mm_s_ = std::max(max_v_mm_s_, point.v_mm_s);
    if (std::abs(point.v_mm_s - from.v_mm_s) > tolerance_.v_share * max_v_mm_s_) {
      return false;
    }
  }
  const double du = point.at.u_mm - from.at.u_mm;
  const double dv = point.at.v_mm - from.at.v_mm;
  const double distance = std::hypot(du, dv);
  // A stretch that turns back would hide how far it went.
  if (distance < farthest_mm_ - tolerance_.distance_mm) {
    return false;
  }
  farthest_mm_ = std::max(farthest_mm_, distance);
  if (distance <= tolerance_.distance_mm) {
    return true;
  }
  const double half_rad = std::asin(tolerance_.distance_mm / distance);
  const double direction_rad = std::atan2(dv, du);
  if (!sector_) {
    sector_ = Sector{.axis_rad = direction_rad, .low_rad = -half_rad, .high_rad = half_rad};
    return true;
  }
  const double angle_rad =
      std::remainder(direction_rad - sector_->axis_rad, 2.0 * std::numbers::pi);
  if (angle_rad < sector_->low_rad || angle_rad > sector_->high_rad) {
    return false;
  }
  sector_->low_rad = std::max(sector_->low_rad, angle_rad - half_rad);
  sector_->high_rad = std::min(sector_->high_rad, angle_rad + half_rad);
  return true;
}

void PathOutline::keep(const OutlinePoint& point) {
  kept_.push_back(point);
  last_.reset();
  sector_.reset();
  farthest_mm_ = 0.0;
}

void PathOutline::add(const OutlinePoint& point) {
  append(point);
  if (kept_.size() >= max_points_) {
    thin();
  }
}

void PathOutline::append(const OutlinePoint& point) {
  if (kept_.empty()) {
    keep(point);
    return;
  }
  if (!extend_stretch(point) && last_) {
    keep(*last_);
    extend_stretch(point);
  }
  last_ = point;
}

void PathOutline::thin() {
  tolerance_.distance_mm *= 2.0;
  tolerance_.v_share *= 2.0;
  const std::optional<OutlinePoint> last = last_;
  PathOutline thinner(tolerance_, max_points_);
  for (const OutlinePoint& point : kept_) {
    thinner.append(point);
  }
  // Closed at its end, as this outline is here.
  if (thinner.last_) {
    thinner.keep(*thinner.last_);
  }
  *this = std::move(thinner);
  if (last) {
    append(*last);
  }
}

std::vector<OutlinePoint> PathOutline::points() const {
  std::vector<OutlinePoint> points = kept_;
  if (last_) {
    points.push_back(*last_);
  }
  return points;
}

}  // namespace kerf::program
