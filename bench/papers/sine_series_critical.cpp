// [SineSeries] divides a curve at its critical points: the ends, and where curvature is highest and
// above a threshold.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "bench/curve_run.hpp"
#include "bench/papers/papers.hpp"
#include "bench/papers/sigmoid_method.hpp"

namespace kerf::bench {

using profiles::Profile;
using profiles::ProfileKind;

namespace {

struct CurvatureMaximum {
  double s_mm = 0.0;
  double curvature_per_mm = 0.0;
};

struct Curvature {
  std::vector<CurvatureMaximum> maxima;  // along the curve
  double length_mm = 0.0;
};

struct Published {
  const char* name;
  std::size_t points;  // the ends among them
  const char* why;
};
constexpr Published kButterfly{"butterfly", 37, ""};
constexpr Published kTrident{"trident7", 7, "; the trident's points are lost"};

Curvature curvature_of(const Published& of, const lookahead::PlanLimits& limits) {
  constexpr int kPlaces = 400'000;
  const lookahead::Block block = curve_block(std::string(of.name) + ".ngc", limits);
  const auto& curve = std::get<curves::NurbsCurve>(block.curve);
  Curvature found{.maxima = {}, .length_mm = curve.length_mm()};
  CurvatureMaximum before;
  CurvatureMaximum here;
  for (int i = 0; i <= kPlaces; ++i) {
    const double s = curve.length_mm() * i / kPlaces;
    const double after = curves::vec(curve.derivatives_at(s).second_per_mm).norm();
    if (i > 1 && here.curvature_per_mm > before.curvature_per_mm &&
        here.curvature_per_mm >= after) {
      found.maxima.push_back(here);
    }
    before = std::exchange(here, {.s_mm = s, .curvature_per_mm = after});
  }
  return found;
}

// The thresholds that leave as many points as published: above the first, up to the second.
struct Thresholds {
  double above_per_mm = 0.0;
  double to_per_mm = 0.0;  // 0: the curve has too few maxima
};

Thresholds thresholds_of(const Curvature& curvature, const Published& published) {
  std::vector<double> sorted;
  for (const CurvatureMaximum& maximum : curvature.maxima) {
    sorted.push_back(maximum.curvature_per_mm);
  }
  std::ranges::sort(sorted);
  if (sorted.size() + 2 < published.points) {
    return {};
  }
  const std::size_t first = sorted.size() + 2 - published.points;
  return {.above_per_mm = first > 0 ? sorted[first - 1] : 0.0, .to_per_mm = sorted[first]};
}

// From here on the chord error binds at the programmed feedrate [LeeEtAl].
double bound_by_chord_per_mm(const lookahead::PlanLimits& limits) {
  const double way = limits.path.velocity_mm_s * limits.period_s;
  const double d = limits.chord_tolerance_mm;
  return 8.0 * d / (way * way + 4.0 * d * d);
}

// The feedrate that the curvature allows: the chord error's and, if asked, that of the path's
// limits across the path (docs/math.md, 5.6).
double nominal_mm_s(double curvature_per_mm, const lookahead::PlanLimits& limits, bool across) {
  const double d = limits.chord_tolerance_mm;
  const double by_chord =
      2.0 / limits.period_s * std::sqrt(std::max(2.0 * d / curvature_per_mm - d * d, 0.0));
  const double v = std::min(limits.path.velocity_mm_s, by_chord);
  return across
             ? std::min({v, std::sqrt(limits.path.acceleration_mm_s2 / curvature_per_mm),
                         std::cbrt(limits.path.jerk_mm_s3 / (curvature_per_mm * curvature_per_mm))})
             : v;
}

std::vector<MethodPlace> places_of(const Curvature& curvature, const Published& published,
                                   const lookahead::PlanLimits& limits, bool across) {
  const double threshold = thresholds_of(curvature, published).to_per_mm;
  std::vector<MethodPlace> places{{.s_mm = 0.0, .v_mm_s = 0.0}};
  for (const CurvatureMaximum& maximum : curvature.maxima) {
    if (maximum.curvature_per_mm >= threshold) {
      places.push_back(
          {.s_mm = maximum.s_mm, .v_mm_s = nominal_mm_s(maximum.curvature_per_mm, limits, across)});
    }
  }
  places.push_back({.s_mm = curvature.length_mm, .v_mm_s = 0.0});
  return places;
}

struct MethodTimes {
  std::size_t places = 0;
  double sine_s = 0.0;
  double series_s = 0.0;
};

MethodTimes times_over(const Curvature& curvature, const Published& published,
                       const lookahead::PlanLimits& limits, bool across) {
  const std::vector<MethodPlace> places = places_of(curvature, published, limits, across);
  return {.places = places.size(),
          .sine_s = time_over_s(places, Profile(ProfileKind::sine), limits),
          .series_s = time_over_s(places, Profile(ProfileKind::sine_series), limits)};
}

void add(const Published& published, const lookahead::PlanLimits& limits, Comparison& table) {
  const Curvature curvature = curvature_of(published, limits);
  const Thresholds thresholds = thresholds_of(curvature, published);
  const double by_chord = bound_by_chord_per_mm(limits);
  const auto count =
      2.0 + static_cast<double>(std::ranges::count_if(curvature.maxima, [&](const auto& maximum) {
        return maximum.curvature_per_mm >= by_chord;
      }));
  table.require(std::string(published.name) + " has as many maxima of curvature as published",
                thresholds.to_per_mm > 0.0);
  const std::string why = "the ends, and maxima of curvature above " + fixed(by_chord, 3) +
                          " /mm, where the chord error binds; the paper's threshold is lost, " +
                          fixed(thresholds.above_per_mm, 4) + " to " +
                          fixed(thresholds.to_per_mm, 4) + " /mm gives " +
                          std::to_string(published.points) + published.why;
  const auto points = static_cast<double>(published.points);
  for (const auto& [what, less] : {std::pair{"critical points", 0.0}, std::pair{"segments", 1.0}}) {
    table.add({.name = std::string(published.name) + ", " + what,
               .published = points - less,
               .here = count - less,
               .tolerance = 0.5,
               .band = 18.0,
               .why = why,
               .impossible = true});
  }
}

}  // namespace

void add_critical_points(const lookahead::PlanLimits& limits, Comparison& table) {
  add(kButterfly, limits, table);
  add(kTrident, limits, table);
  const MethodTimes times = times_over(curvature_of(kButterfly, limits), kButterfly, limits, false);
  const std::string why = "the limits are inferred, with Kerf's plan, and so is the threshold";
  for (const auto& [law, published, here] : {std::tuple{"single sine", 5.427, times.sine_s},
                                             std::tuple{"sine series", 4.802, times.series_s}}) {
    table.add({.name = std::string("butterfly, the paper's method, ") + law + " [s]",
               .published = published,
               .decimals = 3,
               .here = here,
               .tolerance = 0.003,
               .band = 0.016,
               .why = why});
  }
}

void print_over_critical_points(const lookahead::PlanLimits& limits) {
  std::printf(
      "The paper's method: transitions between its critical points alone, with the feedrates that "
      "curvature allows there, from rest to rest. Normal limits: those along the path, taken for "
      "across it, too.\n\n| curve | critical points | normal limits | single sine [s] | sine "
      "series "
      "[s] | less time [%%] |\n| --- | --- | --- | --- | --- | --- |\n");
  for (const Published& published : {kButterfly, kTrident}) {
    const Curvature curvature = curvature_of(published, limits);
    for (const bool across : {false, true}) {
      const MethodTimes times = times_over(curvature, published, limits, across);
      std::printf("| %s | %zu | %s | %.3f | %.3f | %.1f |\n", published.name, times.places,
                  across ? "yes" : "no", times.sine_s, times.series_s,
                  100.0 * (1.0 - times.series_s / times.sine_s));
    }
  }
  std::printf("\n");
}

}  // namespace kerf::bench
