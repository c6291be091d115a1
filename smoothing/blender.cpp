#include "smoothing/blender.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "smoothing/blend.hpp"
#include "smoothing/segment_marks.hpp"
#include "smoothing/travel.hpp"

namespace kerf::smoothing {

namespace {

constexpr double kSmooth = 1e-9;        // of a turn, and of a curvature's jump by mm
constexpr double kSharpest = 1.95;      // 2 sin(77 degrees)
constexpr double kOfTolerance = 0.999;  // rounding and the places between those looked at
constexpr double kOfRadius = 0.5;       // of a curve beside a corner
constexpr double kOfNeed = 1.3;         // of the way that the feedrate needs
constexpr double kMinWay_mm = 1e-5;
constexpr double kMinRest_mm =
    1e-6;  // of a segment between two blends; a shorter one goes with one
constexpr int kShrinkings = 16;

// What a corner gets of a segment whose other corner wants some, too: no less than half.
double allotted_mm(double wanted_mm, double other_mm, double length_mm) {
  return std::min(wanted_mm, std::max(0.5 * length_mm, length_mm - other_mm));
}

double feedrate_mm_s(const PathSegment& segment) {
  return segment.rapid ? std::numeric_limits<double>::infinity() : segment.feedrate_mm_s;
}

}  // namespace

bool may_bend(const PathSegment& segment) {
  return segment.mode == parser::PathMode::blend && segment.corner_tolerance_mm > 0.0 &&
         segment.extra.length_mm == 0.0;
}

double way_through_jump_mm(const CornerShape& shape, double feedrate_mm_s,
                           const BlendSettings& settings) {
  const double v2 = feedrate_mm_s * feedrate_mm_s;
  return 1.5 * shape.bend_per_mm * v2 * feedrate_mm_s / settings.jerk_mm_s3;
}

bool Blender::are_of_two_blocks(const Held& before, const Held& after) {
  return before.segment.mark_at(before.length_mm).run_block != after.segment.mark_at(0.0).run_block;
}

double Blender::wanted_way_mm(const Held& before, const Held& after) const {
  if (keeps_blocks_apart_ && are_of_two_blocks(before, after)) {
    return 0.0;
  }
  if (!may_bend(before.segment) || !may_bend(after.segment) || after.segment.continues) {
    return 0.0;
  }
  const CornerShape shape =
      shape_of({.before = &before.segment.curve, .after = &after.segment.curve});
  if ((shape.turn < kSmooth && shape.bend_per_mm < kSmooth) || shape.turn > kSharpest) {
    return 0.0;
  }
  const double tolerance = kOfTolerance * std::min(before.segment.corner_tolerance_mm,
                                                   after.segment.corner_tolerance_mm) -
                           std::max(before.segment.deviation_mm, after.segment.deviation_mm);
  if (!(tolerance > 0.0)) {
    return 0.0;
  }
  double way = std::numeric_limits<double>::infinity();
  if (shape.turn > 0.0) {
    way = std::min(way, 8.0 * tolerance / shape.turn);
  }
  if (shape.curvature_per_mm > 0.0) {
    way = std::min(way, kOfRadius / shape.curvature_per_mm);
  }
  const double feedrate = std::min(feedrate_mm_s(before.segment), feedrate_mm_s(after.segment));
  if (std::isfinite(feedrate)) {
    // The curvature in the middle of a blend of way 1 between two lines, where |r'| = 1.5 cos and
    // |r' x r''| = 9 sin cos of half the angle; the largest third derivative is some 2.5 times it
    // over the way.
    const double half_sine = 0.5 * shape.turn;
    const double curvature = 8.0 / 3.0 * half_sine / (1.0 - half_sine * half_sine);
    const double v2 = feedrate * feedrate;
    const double need =
        std::max(curvature * v2 / settings_.acceleration_mm_s2,
                 std::sqrt(2.5 * curvature * v2 * feedrate / settings_.jerk_mm_s3)) +
        way_through_jump_mm(shape, feedrate, settings_);
    way = std::min(way, kOfNeed * need);
  }
  return way;
}

std::optional<Blender::Chosen> Blender::choose(const Held& before, const Held& after,
                                               double way_mm) {
  const Corner corner{.before = &before.segment.curve, .after = &after.segment.curve};
  const double tolerance =
      std::min(before.segment.corner_tolerance_mm, after.segment.corner_tolerance_mm);
  const double away_mm = std::max(before.segment.deviation_mm, after.segment.deviation_mm);
  for (int i = 0; i < kShrinkings && way_mm > kMinWay_mm; ++i) {
    auto blend = make_blend(corner, way_mm);
    if (!blend) {
      return std::nullopt;
    }
    PathDeviation deviation = deviation_of(*blend, corner, way_mm);
    deviation.distance_mm += away_mm;
    if (deviation.distance_mm <= kOfTolerance * tolerance + 1e-12 &&
        !(settings_.travel && leaves_travel(blend->curve.extents(), *settings_.travel))) {
      deviation.line = after.segment.mark_at(0.0).line;
      deviation.tolerance_mm = tolerance;
      deviations_.add(deviation);
      return Chosen{
          .blend = std::move(*blend), .way_mm = way_mm, .deviation_mm = deviation.distance_mm};
    }
    way_mm *= 0.75;
  }
  return std::nullopt;
}

void Blender::push(PathSegment segment, std::vector<PathSegment>& out) {
  Held held{.segment = std::move(segment)};
  held.length_mm = curves::length_mm(held.segment.curve);
  if (!first_) {
    first_ = std::move(held);
    return;
  }
  Held& before = second_ ? *second_ : *first_;
  held.wanted_mm = wanted_way_mm(before, held);
  if (second_) {
    settle(held.wanted_mm, out);
  }
  second_ = std::move(held);
}

void Blender::flush(std::vector<PathSegment>& out) {
  if (second_) {
    settle(0.0, out);
  }
  if (first_) {
    emit_rest_of(*first_, 0.0, out);
    first_.reset();
  }
}

void Blender::settle(double wanted_at_end_mm, std::vector<PathSegment>& out) {
  const double free_mm = first_->length_mm - first_->cut_begin_mm;
  double way =
      std::min(allotted_mm(second_->wanted_mm, wanted_at_end_mm, second_->length_mm), free_mm);
  const double max_mm = second_->length_mm - kMinRest_mm;
  way = std::min(way, max_mm);
  if (free_mm - way < kMinRest_mm) {
    way = free_mm <= max_mm ? free_mm : std::min(free_mm, max_mm) - kMinRest_mm;
  }
  std::optional<Chosen> chosen;
  if (second_->wanted_mm > kMinWay_mm && way > kMinWay_mm) {
    chosen = choose(*first_, *second_, way);
  }
  const double cut_end = chosen ? chosen->way_mm : 0.0;
  const std::size_t before = out.size();
  emit_rest_of(*first_, cut_end, out);
  if (chosen) {
    first_->is_gone = out.size() == before;
    emit_blend(std::move(*chosen), *first_, *second_, out);
  }
  first_ = std::move(second_);
  second_.reset();
}

void Blender::emit_rest_of(Held& held, double cut_end_mm, std::vector<PathSegment>& out) const {
  PathSegment& segment = held.segment;
  if (held.cut_begin_mm == 0.0 && cut_end_mm == 0.0) {
    out.push_back(std::move(segment));
    return;
  }
  const curves::Stretch rest{held.cut_begin_mm, held.length_mm - cut_end_mm};
  if (!(rest.end_mm - rest.begin_mm >= 0.5 * kMinRest_mm)) {
    return;
  }
  auto curve = curves::part(segment.curve, rest);
  if (!curve) {
    return;
  }
  PathSegment& left = out.emplace_back(segment);
  left.curve = std::move(*curve);
  left.continues = left.continues || held.follows_blend;
  shift_marks(left, rest.begin_mm);
}

void Blender::emit_blend(Chosen chosen, const Held& before, Held& after,
                         std::vector<PathSegment>& out) const {
  std::vector<LineMark> marks =
      marks_along(chosen.blend, chosen.way_mm, before.segment, after.segment);
  PathSegment segment{.curve = std::move(chosen.blend.curve)};
  segment.marks = std::move(marks);
  segment.source = {.line = segment.marks.front().line, .column = before.segment.source.column};
  segment.run_block = segment.marks.front().run_block;
  segment.corner_block = after.segment.mark_at(0.0).run_block;
  segment.rapid = before.segment.rapid && after.segment.rapid;
  const bool is_before = feedrate_mm_s(before.segment) <= feedrate_mm_s(after.segment);
  const PathSegment& slower = is_before ? before.segment : after.segment;
  segment.feedrate_mm_s = feedrate_mm_s(slower);
  segment.follows = slower.follows;
  segment.extra = {.begin_rad_mm = before.segment.extra.end_rad_mm,
                   .end_rad_mm = before.segment.extra.end_rad_mm};
  segment.mode = parser::PathMode::blend;
  segment.deviation_mm = chosen.deviation_mm;
  segment.continues = !before.is_gone || before.follows_blend || before.segment.continues;
  after.cut_begin_mm = chosen.way_mm;
  after.follows_blend = true;
  out.push_back(std::move(segment));
}

}  // namespace kerf::smoothing
