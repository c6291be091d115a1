// The 37 breaking points of [Sigmoid, section 5.2], and which turns of the feedrate they leave out.
#include <algorithm>
#include <cstdio>
#include <string>

#include "bench/papers/butterfly_method.hpp"
#include "lookahead/classical/limit_curve_cuts.hpp"

namespace kerf::bench {

using lookahead::VelocityLimitCurve;

namespace {

constexpr std::size_t kPublished = 37;
constexpr double kStep_mm_s = 10.0;
constexpr double kMaxScreening_mm_s = 10'000.0;

struct Screening {
  double from_mm_s = 0.0;
  double to_mm_s = -1.0;  // below from_mm_s: no value gives as many
};

// The values that give as many as published.
Screening screening_of(const VelocityLimitCurve& scan) {
  Screening found;
  for (int i = 0; i * kStep_mm_s <= kMaxScreening_mm_s; ++i) {
    if (lookahead::breaking_points(scan, i * kStep_mm_s).size() == kPublished) {
      found.from_mm_s = found.to_mm_s < 0.0 ? i * kStep_mm_s : found.from_mm_s;
      found.to_mm_s = i * kStep_mm_s;
    }
  }
  return found;
}

// Of the two dips beside the ends, from 66 to 60 mm/s.
std::size_t dips_among(const VelocityLimitCurve& scan, double screening_mm_s) {
  constexpr double kBesideEnd_mm = 1.0;
  constexpr double kDip_mm_s = 61.0;
  const auto breaking = lookahead::breaking_points(scan, screening_mm_s);
  return static_cast<std::size_t>(std::ranges::count_if(breaking, [&](std::size_t i) {
    const double to_end =
        std::min(scan[i].s_mm - scan.front().s_mm, scan.back().s_mm - scan[i].s_mm);
    return to_end < kBesideEnd_mm && scan[i].v_mm_s < kDip_mm_s;
  }));
}

void print(const std::string& name, const VelocityLimitCurve& scan, Comparison& table) {
  const Screening screening = screening_of(scan);
  table.require("37 breaking points by " + name, screening.to_mm_s >= screening.from_mm_s);
  std::printf("| %s | %zu | %.0f to %.0f | %zu |\n", name.c_str(),
              lookahead::breaking_points(scan, 0.0).size(), screening.from_mm_s, screening.to_mm_s,
              dips_among(scan, screening.from_mm_s));
}

}  // namespace

void add_breaking_points(const MethodCurve& curve, const lookahead::PlanLimits& limits,
                         Comparison& table) {
  const VelocityLimitCurve scan = method_scan(curve, ChordRule::largest_distance, limits);
  const Screening screening = screening_of(scan);
  const auto count =
      static_cast<double>(lookahead::breaking_points(scan, screening.from_mm_s).size());
  const std::string why = "with a screening value of " + fixed(screening.from_mm_s, 0) + " to " +
                          fixed(screening.to_mm_s, 0) +
                          " mm/s, which the paper does not print: see below";
  table.add(
      {.name = "breaking points", .published = 37, .here = count, .tolerance = 0.5, .why = why});
  table.add({.name = "blocks", .published = 36, .here = count - 1.0, .tolerance = 0.5, .why = why});
}

void print_breaking_points(const MethodCurve& curve, const VelocityLimitCurve& kerf_scan,
                           const lookahead::PlanLimits& limits, Comparison& table) {
  std::printf(
      "Breaking points by screening. A count of 37 does not say which turns are left out: the two "
      "dips of the limit beside the ends, from 66 to 60 mm/s, may be among them or not.\n\n"
      "| scan | without screening | screening that gives 37 [mm/s] | dips among them |\n| --- | "
      "--- "
      "| --- | --- |\n");
  print("Kerf's, by arc length", kerf_scan, table);
  for (const Rule& rule : kRules) {
    print(std::string("one row of ticks, ") + rule.name, method_scan(curve, rule.rule, limits),
          table);
  }
  std::printf("\n");
}

}  // namespace kerf::bench
