#include "lookahead/path/normal_limits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace kerf::lookahead {

using curves::NurbsPiece;

namespace {

// Of the feedrate: what lines between samples may miss, and so the bound is lower by it.
constexpr double kMissed = 4e-4;
constexpr int kPartsOfPiece = 4;
constexpr int kMaxHalvings = 10;

FeedSample sample_at(const NurbsPiece& piece, double s_mm, const PlanLimits& limits) {
  const Bound bound =
      normal_bound(curves::vec(piece.derivatives_at(s_mm).second_per_mm).norm(), limits);
  return {.u = piece.u_at(s_mm),
          .s_mm = s_mm,
          .v_mm_s = (1.0 - kMissed) * bound.value,
          .limit = bound.from};
}

// Of the normal limits alone.
class Scan {
 public:
  Scan(const PlanLimits& limits, double cap_mm_s) : limits_(limits), cap_mm_s_(cap_mm_s) {}

  void add(const NurbsPiece& piece) {
    FeedSample from = capped(piece, piece.s_begin_mm);
    append(from);
    for (int i = 1; i <= kPartsOfPiece; ++i) {
      const double share = static_cast<double>(i) / kPartsOfPiece;
      const FeedSample to =
          capped(piece, i == kPartsOfPiece
                            ? piece.s_end_mm
                            : piece.s_begin_mm + share * (piece.s_end_mm - piece.s_begin_mm));
      add_between(piece, from, to, kMaxHalvings);
      append(to);
      from = to;
    }
  }
  [[nodiscard]] const VelocityLimitCurve& samples() const { return samples_; }

 private:
  [[nodiscard]] FeedSample capped(const NurbsPiece& piece, double s_mm) const {
    FeedSample sample = sample_at(piece, s_mm, limits_);
    sample.v_mm_s = std::min(sample.v_mm_s, cap_mm_s_);
    return sample;
  }

  // NOLINTNEXTLINE(misc-no-recursion): no deeper than kMaxHalvings.
  void add_between(const NurbsPiece& piece, const FeedSample& a, const FeedSample& b,
                   int halvings) {
    const FeedSample middle = capped(piece, 0.5 * (a.s_mm + b.s_mm));
    const bool finer = halvings > 0 && std::abs(0.5 * (a.v_mm_s + b.v_mm_s) - middle.v_mm_s) >
                                           kMissed * middle.v_mm_s;
    if (finer) {
      add_between(piece, a, middle, halvings - 1);
    }
    append(middle);
    if (finer) {
      add_between(piece, middle, b, halvings - 1);
    }
  }

  // Of samples at one place, as where curvature jumps, the slower counts.
  void append(const FeedSample& sample) {
    if (!samples_.empty() &&
        !(sample.s_mm > samples_.back().s_mm && sample.u > samples_.back().u)) {
      samples_.back().v_mm_s = std::min(samples_.back().v_mm_s, sample.v_mm_s);
    } else {
      samples_.push_back(sample);
    }
  }

  const PlanLimits& limits_;
  double cap_mm_s_;
  VelocityLimitCurve samples_;
};

// The value of a line through samples; the first or last one's beyond them.
class LimitLine {
 public:
  explicit LimitLine(const VelocityLimitCurve& samples) : samples_(samples) {}

  // Places must ascend.
  FeedSample at(double s_mm) {
    while (next_ < samples_.size() && samples_[next_].s_mm <= s_mm) {
      ++next_;
    }
    if (next_ == 0) {
      return samples_.front();
    }
    const FeedSample& a = samples_[next_ - 1];
    FeedSample found = a;
    if (next_ < samples_.size()) {
      const FeedSample& b = samples_[next_];
      const double share = (s_mm - a.s_mm) / (b.s_mm - a.s_mm);
      found.v_mm_s += share * (b.v_mm_s - a.v_mm_s);
      found.u += share * (b.u - a.u);
    }
    found.s_mm = s_mm;
    return found;
  }

 private:
  const VelocityLimitCurve& samples_;
  std::size_t next_ = 0;
};

}  // namespace

Bound normal_bound(double curvature_per_mm, const PlanLimits& limits) {
  Bound bound;
  if (curvature_per_mm > 0.0) {
    const double by_acceleration = std::sqrt(limits.normal_acceleration_mm_s2 / curvature_per_mm);
    const double by_jerk =
        std::cbrt(limits.normal_jerk_mm_s3 / (curvature_per_mm * curvature_per_mm));
    bound = by_acceleration <= by_jerk ? Bound{by_acceleration, Constraint::path_acceleration}
                                       : Bound{by_jerk, Constraint::path_jerk};
  }
  return bound;
}

void lower_to_normal_limits(const curves::NurbsCurve& curve, const PlanLimits& limits,
                            VelocityLimitCurve& limit_curve) {
  if (!std::isfinite(limits.normal_acceleration_mm_s2) &&
      !std::isfinite(limits.normal_jerk_mm_s3)) {
    return;
  }
  Scan scan(limits, std::ranges::max(limit_curve, {}, &FeedSample::v_mm_s).v_mm_s);
  for (const NurbsPiece& piece : curve.pieces()) {
    scan.add(piece);
  }
  // Both are lines between their samples, so their lower one is below both at all of their places;
  // where they cross between two, the line between lies below it.
  VelocityLimitCurve places;
  std::ranges::merge(limit_curve, scan.samples(), std::back_inserter(places), {}, &FeedSample::s_mm,
                     &FeedSample::s_mm);
  LimitLine before(limit_curve);
  LimitLine normal(scan.samples());
  VelocityLimitCurve lower;
  for (const FeedSample& place : places) {
    const FeedSample a = before.at(place.s_mm);
    const FeedSample b = normal.at(place.s_mm);
    FeedSample sample = b.v_mm_s < a.v_mm_s ? b : a;
    sample.s_mm = place.s_mm;
    sample.u = place.u;
    if (lower.empty() || (sample.s_mm > lower.back().s_mm && sample.u > lower.back().u)) {
      lower.push_back(sample);
    } else {
      lower.back().v_mm_s = std::min(lower.back().v_mm_s, sample.v_mm_s);
    }
  }
  lower.back().s_mm = limit_curve.back().s_mm;
  limit_curve = std::move(lower);
}

}  // namespace kerf::lookahead
