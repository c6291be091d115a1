#include "smoothing/run_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "smoothing/travel.hpp"

namespace kerf::smoothing {

using curves::vec;

namespace {

constexpr double kAimed = 0.5;     // of the tolerance: finer spans where the curve is farther off
constexpr double kOfRise = 0.9;    // of the lines' chords: finer spans come no nearer to them
constexpr double kAllowed = 0.95;  // where spans cannot be finer
constexpr int kRounds = 8;
constexpr double kSamplesOfSpan = 6.0;
constexpr double kHighChord = 0.4;  // tolerances: lines whose middle has to be looked at, too

class Fitting {
 public:
  Fitting(const Polyline& run, const RunStretch& stretch, const std::optional<SplineTail>& tail,
          std::span<const std::size_t> breaks, const RunFitSettings& settings)
      : run_(&run),
        stretch_(stretch),
        ends_{.begin_mm = run[0].point_mm, .tail = tail},
        settings_(&settings),
        breaks_(run, breaks,
                {.last = stretch.last,
                 .before_mm = tail ? tail->span_mm : 0.0,
                 .tolerance_mm = settings.tolerance_mm}) {
    if (stretch_.pinned) {
      ends_.end_mm = point(stretch_.last);
    }
  }

  RunFit find() {
    RunFit fit;
    for (int round = 0;; ++round) {
      fit.spline = solve();
      fit.fails_at.reset();
      if (!judge(fit, round + 1 < kRounds) &&
          (fit.fails_at ||
           !hold_ends(*run_, stretch_, fit.spline, settings_->tolerance_mm, ends_))) {
        break;
      }
    }
    fit.breaks = breaks_.vertices();
    return fit;
  }

 private:
  // At the begin of a span.
  [[nodiscard]] std::size_t vertex(std::size_t span) const { return breaks_.vertices()[span]; }
  [[nodiscard]] double w_mm(std::size_t vertex) const { return (*run_)[vertex].w_mm; }
  [[nodiscard]] const curves::Position& point(std::size_t vertex) const {
    return (*run_)[vertex].point_mm;
  }

  struct SpanLength {
    double mm = 0.0;
  };

  // Into how many steps a line is divided.
  [[nodiscard]] std::size_t steps_of(std::size_t line, SpanLength span) const {
    const double length = w_mm(line + 1) - w_mm(line);
    auto steps = static_cast<std::size_t>(std::ceil(kSamplesOfSpan * length / span.mm));
    if (line > 0 && line + 1 < stretch_.last) {
      const Eigen::Vector3d in = vec(point(line)) - vec(point(line - 1));
      const Eigen::Vector3d along = vec(point(line + 1)) - vec(point(line));
      const double turn = in.cross(along).norm() / (in.norm() * length);
      if (length * turn > 8.0 * kHighChord * settings_->tolerance_mm) {
        steps = std::max<std::size_t>(steps, 2);
      }
    }
    return std::max<std::size_t>(steps, 1);
  }

  // Of the lines' chords over a curve through their vertices, the highest of the span.
  [[nodiscard]] double rise_mm(std::size_t k) const {
    double most = 0.0;
    for (std::size_t i = std::max<std::size_t>(vertex(k), 1);
         i < std::min(vertex(k + 1), stretch_.last - 1); ++i) {
      const Eigen::Vector3d in = vec(point(i)) - vec(point(i - 1));
      const Eigen::Vector3d along = vec(point(i + 1)) - vec(point(i));
      most = std::max(most, 0.125 * in.cross(along).norm() / std::min(in.norm(), along.norm()));
    }
    return most;
  }

  SplineFit solve() {
    samples_.clear();
    samples_.push_back({.w_mm = w_mm(0), .weight = 0.0, .point_mm = point(0)});
    for (std::size_t k = 0; k < breaks_.span_count(); ++k) {
      const double span = w_mm(vertex(k + 1)) - w_mm(vertex(k));
      for (std::size_t i = vertex(k); i < vertex(k + 1); ++i) {
        const std::size_t steps = steps_of(i, {span});
        const double length = w_mm(i + 1) - w_mm(i);
        const double half = 0.5 * length / static_cast<double>(steps);
        for (std::size_t step = 1; step <= steps; ++step) {
          samples_.back().weight += half;
          const double share = static_cast<double>(step) / static_cast<double>(steps);
          samples_.push_back(
              {.w_mm = w_mm(i) + share * length, .weight = half, .point_mm = between(i, share)});
        }
      }
    }
    breaks_mm_.clear();
    for (const std::size_t vertex : breaks_.vertices()) {
      breaks_mm_.push_back(w_mm(vertex));
    }
    return fit_spline(breaks_mm_, samples_, ends_);
  }

  [[nodiscard]] curves::Position between(std::size_t line, double share) const {
    if (share == 1.0) {
      return point(line + 1);
    }
    return curves::to_position((1.0 - share) * vec(point(line)) + share * vec(point(line + 1)));
  }

  [[nodiscard]] bool is_outside(const Eigen::Vector3d& place) const {
    const curves::Position at = curves::to_position(place);
    return settings_->travel && leaves_travel({.min_mm = at, .max_mm = at}, *settings_->travel);
  }

  // At twice as many places as there are samples.
  [[nodiscard]] double away_mm(const FitSpan& span, std::size_t k) const {
    const double bend = span.bend_bound_per_mm();
    double away = 0.0;
    for (std::size_t i = vertex(k); i < vertex(k + 1); ++i) {
      const std::size_t steps = 2 * steps_of(i, {span.w_end_mm - span.w_begin_mm});
      const double length = w_mm(i + 1) - w_mm(i);
      const double step_mm = length / static_cast<double>(steps);
      const double between_mm = 0.125 * step_mm * step_mm * bend;
      for (std::size_t step = 1; step <= steps; ++step) {
        const double share = static_cast<double>(step) / static_cast<double>(steps);
        const Eigen::Vector3d place = span.at(w_mm(i) + share * length);
        away = std::max(away, (place - vec(between(i, share))).norm() + between_mm);
        if (is_outside(place)) {
          away = std::numeric_limits<double>::infinity();
        }
      }
    }
    return away;
  }

  // The sharpest vertex of the span, where it is to be a corner.
  [[nodiscard]] std::size_t sharpest(std::size_t k) const {
    std::size_t found = std::max<std::size_t>(std::min(vertex(k), stretch_.last - 1), 1);
    double most = -1.0;
    const std::size_t from = std::max<std::size_t>(vertex(k), 1);
    for (std::size_t i = from; i <= std::min(vertex(k + 1), stretch_.last - 1); ++i) {
      const Eigen::Vector3d in = vec(point(i)) - vec(point(i - 1));
      const Eigen::Vector3d out = vec(point(i + 1)) - vec(point(i));
      const double turn = turn_rad(in, out);
      if (turn > most) {
        most = turn;
        found = i;
      }
    }
    return found;
  }

  // True: spans were divided, and it is to be solved again.
  bool judge(RunFit& fit, bool may_divide) {
    const std::size_t spans = breaks_.span_count();
    std::vector<bool> divide(spans, false);
    fit.away_mm.clear();
    for (std::size_t k = 0; k < spans; ++k) {
      const double away = away_mm(fit.spline.spans[k], k);
      fit.away_mm.push_back(away);
      const double aimed = std::clamp(kOfRise * rise_mm(k), kAimed * settings_->tolerance_mm,
                                      kAllowed * settings_->tolerance_mm);
      if (vertex(k) > stretch_.judged || away <= aimed) {
        continue;
      }
      divide[k] = may_divide && breaks_.is_divisible(k);
      if (!divide[k] && !(away <= kAllowed * settings_->tolerance_mm) && !fit.fails_at) {
        fit.fails_at = sharpest(k);
      }
    }
    if (std::find(divide.begin(), divide.end(), true) == divide.end()) {
      return false;
    }
    breaks_.divide(std::move(divide));
    return true;
  }

  const Polyline* run_;
  RunStretch stretch_;
  FitEnds ends_;
  const RunFitSettings* settings_;
  SpanBreaks breaks_;
  std::vector<double> breaks_mm_;
  std::vector<FitSample> samples_;
};

}  // namespace

RunFit fit_run(const Polyline& run, const RunStretch& stretch,
               const std::optional<SplineTail>& tail, std::span<const std::size_t> breaks,
               const RunFitSettings& settings) {
  return Fitting(run, stretch, tail, breaks, settings).find();
}

}  // namespace kerf::smoothing
