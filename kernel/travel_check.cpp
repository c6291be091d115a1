#include "kernel/travel_check.hpp"

#include "smoothing/segment_builder.hpp"

namespace kerf {

TravelCheck::TravelCheck(const MachineSettings& settings)
    : envelope_(machine::envelope_of(settings.table)), extra_envelope_(settings.table.extra) {}

std::optional<machine::TravelExcess> TravelCheck::excess_of(const parser::Move& move) {
  segments_.clear();
  if (!smoothing::append_segments(move, segments_) || segments_.empty()) {
    return std::nullopt;
  }
  if (auto excess = machine::outside_travel(extra_envelope_, move.auxiliary.end_rad_mm)) {
    return excess;
  }
  for (const smoothing::PathSegment& segment : segments_) {
    if (auto excess = machine::outside_travel(envelope_, curves::extents(segment.curve))) {
      return excess;
    }
  }
  return std::nullopt;
}

}  // namespace kerf
