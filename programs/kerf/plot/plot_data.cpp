#include "programs/kerf/plot/plot_data.hpp"

#include <algorithm>

namespace kerf::program {

namespace {

constexpr double kMicrometre = 1e3;

// A quarter of a pixel on a picture some 700 pixels wide, and half a step of colour.
OutlineTolerance tolerance_of(const curves::Extents& extents) {
  const PaperBox box = box_of(view_of(extents), extents);
  return {.distance_mm = std::max(box.width_mm(), box.height_mm()) / 2800.0, .v_share = 1.0 / 64.0};
}

}  // namespace

PlotData::PlotData(const curves::Extents& extents)
    : view_(view_of(extents)),
      outline_(tolerance_of(extents)),
      sharp_places_(view_, box_of(view_, extents)) {}

void PlotData::add(const TickRecord& record) {
  outline_.add({.at = project(view_, record.position_mm),
                .v_mm_s = record.motion.v_mm_s,
                .rapid = record.rapid});
  sharp_places_.add(record.position_mm, record.line, record.rapid);
  if (!record.rapid) {
    max_feedrate_mm_s_ = std::max(max_feedrate_mm_s_, record.motion.v_mm_s);
  }
  v_.add(record.tick, record.motion.v_mm_s);
  a_.add(record.tick, record.motion.a_mm_s2);
  j_.add(record.tick, record.motion.j_mm_s3);
  chord_error_um_.add(record.tick, kMicrometre * record.detail.chord_error_mm);
  if (scan_) {
    scan_->add(record);
  }
  if (limits_) {
    limits_->add(record.tick, record.limit);
  }
  last_tick_ = record.tick;
}

}  // namespace kerf::program
