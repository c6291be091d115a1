// How corners are blended, said once: the plan without ticks and the run must have the same path.
#pragma once

#include <algorithm>
#include <cstddef>

#include "curves/position.hpp"
#include "kernel/settings.hpp"
#include "machine/envelope.hpp"
#include "smoothing/blender.hpp"

namespace kerf {

// The weakest axis' limits, and the table's travel.
inline smoothing::BlendSettings blend_settings(const MachineSettings& settings) {
  const lookahead::PlanLimits& limits = settings.limits;
  smoothing::BlendSettings blend{.acceleration_mm_s2 = limits.path.acceleration_mm_s2,
                                 .jerk_mm_s3 = limits.path.jerk_mm_s3};
  const machine::Envelope envelope = machine::envelope_of(settings.table);
  curves::Extents travel;
  for (std::size_t k = 0; k < 3; ++k) {
    blend.acceleration_mm_s2 =
        std::min(blend.acceleration_mm_s2, limits.axes[k].acceleration_mm_s2);
    blend.jerk_mm_s3 = std::min(blend.jerk_mm_s3, limits.axes[k].jerk_mm_s3);
    travel.min_mm[k] = envelope[k].min_mm;
    travel.max_mm[k] = envelope[k].max_mm;
  }
  blend.travel = travel;
  return blend;
}

}  // namespace kerf
