// A report with figures that tests know.
#pragma once

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

inline FileReport sample_report() {
  FileReport report;
  report.file = "wing.ngc";
  report.machine = "default";
  report.profile = "s-curve";
  report.limits.path = {.velocity_mm_s = 200.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55e3};
  report.limits.axes.fill({.velocity_mm_s = 100.0, .jerk_mm_s3 = 55e3});
  report.limits.chord_tolerance_mm = 0.0005;
  report.plan =
      PlanReport{.cycle_time_s = 4.449,
                 .ticks = 4449,
                 .path_length_mm = 383.1234,
                 .blocks = 1,
                 .extents = {.min_mm = {-1e-9, -2.0, 0.0}, .max_mm = {100.0, 65.6666, 5.0}}};
  report.motion =
      MotionReport{.path = {.v_mm_s = 100.0, .a_mm_s2 = 3000.0, .j_mm_s3 = 55e3},
                   .axes = {{{99.0, 2900.0, 1.24e6}, {98.0, 2800.0, 54e3}, {0.0, 0.0, 0.0}}},
                   .chord_error_mm = 0.00025,
                   .max_contour_error_mm = 0.02,
                   .mean_contour_error_mm = 0.004,
                   .max_following_error_mm = {0.03, 0.025, 0.0}};
  return report;
}

}  // namespace kerf::program
