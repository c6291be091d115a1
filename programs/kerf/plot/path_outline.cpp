#include "programs/kerf/plot/path_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "programs/kerf/plot/feed_colours.hpp"
#include "programs/kerf/plot/path_cover.hpp"

namespace kerf::program {

namespace {

// Doubling must get somewhere.
constexpr double kMinTolerance = 1e-9;
// Of the distance tolerance, which is a part of one: what is drawn is about two pixels wide.
constexpr double kPixels = 4.0;
constexpr double kMaxCells = 1000.0;  // in a row
// One colour: what lies farther apart is never drawn as one.
constexpr double kCoarsestShare = 1.0 / static_cast<double>(kColourLevels);

void include(std::optional<PaperBox>& box, const PaperPoint& at) {
  if (!box) {
    box = PaperBox{.min = at, .max = at};
  }
  box->min = {.u_mm = std::min(box->min.u_mm, at.u_mm), .v_mm = std::min(box->min.v_mm, at.v_mm)};
  box->max = {.u_mm = std::max(box->max.u_mm, at.u_mm), .v_mm = std::max(box->max.v_mm, at.v_mm)};
}

}  // namespace

PaperBox box_around(const std::vector<OutlinePoint>& points) {
  std::optional<PaperBox> all;
  std::optional<PaperBox> cut;
  for (std::size_t i = 0; i < points.size(); ++i) {
    include(all, points[i].at);
    if (i > 0 && !points[i].rapid && points[i].at != points[i - 1].at) {
      include(cut, points[i - 1].at);
      include(cut, points[i].at);
    }
  }
  return cut.value_or(*all);
}

std::size_t level_to(std::size_t point, const std::vector<OutlinePoint>& outline,
                     double max_v_mm_s) {
  if (outline[point].rapid) {
    return kColourLevels;
  }
  return colour_level((outline[point - 1].v_mm_s + outline[point].v_mm_s) / 2.0, max_v_mm_s);
}

PathOutline::PathOutline(const OutlineTolerance& tolerance, std::size_t max_points)
    : tolerance_{.distance_mm = std::max(tolerance.distance_mm, kMinTolerance),
                 .v_share = std::max(tolerance.v_share, kMinTolerance)},
      coarsest_share_(std::max(tolerance_.v_share, kCoarsestShare)),
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
    drop_hidden();
    while (kept_.size() > max_points_ / 4 * 3) {
      thin();
      drop_hidden();
    }
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

namespace {

struct OutlineLine {
  std::size_t point = 0;  // that it leads to
  std::size_t level = 0;
};

}  // namespace

// The point that the next line begins at stays, hidden or not.
void PathOutline::drop_hidden() {
  const PaperBox box = box_around(kept_);
  const double cell_mm =
      std::max({kPixels * tolerance_.distance_mm,
                std::max(box.width_mm(), box.height_mm()) / kMaxCells, kMinTolerance});
  // The slowest first: what they hide can be told at once.
  std::vector<OutlineLine> lines;
  for (std::size_t i = 1; i < kept_.size(); ++i) {
    if (!kept_[i].hidden) {
      lines.push_back({.point = i, .level = level_to(i, kept_, max_v_mm_s_)});
    }
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const OutlineLine& a, const OutlineLine& b) { return a.level < b.level; });
  PathCover cover(box, cell_mm);
  for (const OutlineLine& line : lines) {
    kept_[line.point].hidden =
        !cover.draw(kept_[line.point - 1].at, kept_[line.point].at, line.level);
  }
  std::vector<OutlinePoint> shown{kept_.front()};
  for (std::size_t i = 1; i < kept_.size(); ++i) {
    const OutlinePoint& point = kept_[i];
    if (point.hidden && shown.back().hidden) {
      shown.back() = point;
    } else {
      shown.push_back(point);
    }
  }
  kept_ = std::move(shown);
}

void PathOutline::thin() {
  tolerance_.distance_mm *= 2.0;
  tolerance_.v_share = std::min(2.0 * tolerance_.v_share, coarsest_share_);
  const std::optional<OutlinePoint> last = last_;
  PathOutline thinner(tolerance_, max_points_);
  thinner.coarsest_share_ = coarsest_share_;
  thinner.max_v_mm_s_ = max_v_mm_s_;
  for (const OutlinePoint& point : kept_) {
    if (point.hidden && thinner.last_) {
      thinner.keep(*thinner.last_);
    }
    point.hidden ? thinner.keep(point) : thinner.append(point);
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

// The diagonal of a cell.
double PathOutline::line_width_mm() const noexcept {
  return std::sqrt(2.0) * kPixels * tolerance_.distance_mm;
}

std::vector<OutlinePoint> PathOutline::points() const {
  std::vector<OutlinePoint> points = kept_;
  if (last_) {
    points.push_back(*last_);
  }
  return points;
}

}  // namespace kerf::program
