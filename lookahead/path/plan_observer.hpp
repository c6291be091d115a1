// What is told of how a plan is made. Planning side only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "lookahead/path/block.hpp"

namespace kerf::lookahead {

// Where the velocity limit curve of a block was cut.
struct BlockCuts {
  std::uint32_t line = 0;
  std::size_t breaking_points = 0;    // of the limit curve, noise included
  std::size_t velocity_segments = 0;  // that it was cut into
};

// One velocity segment as the passes left it.
struct PlannedSegment {
  std::uint32_t line = 0;
  std::string_view kind{};  // "ACC + CF + DEC"
  double s_begin_mm = 0.0;  // on its block
  double length_mm = 0.0;
  double v_begin_mm_s = 0.0;
  double v_cruise_mm_s = 0.0;
  double v_end_mm_s = 0.0;
  double v_end_allowed_mm_s = 0.0;  // by the valley or the junction; above v_end: it was adjusted
  double duration_s = 0.0;
};

// One search of the time optimum.
struct PlanSearch {
  std::size_t cells = 0;
  bool from_rest = false;
  bool has_plan = false;
  bool slowed_down = false;  // a whole plan from rest, since nothing faster kept the limits
  int newton_steps = 0;
  double duration_s = 0.0;  // of the motion
};

class PlanObserver {
 public:
  PlanObserver() = default;
  PlanObserver(const PlanObserver&) = delete;
  PlanObserver& operator=(const PlanObserver&) = delete;
  virtual ~PlanObserver() = default;

  // A block with its limit curve goes to the plan.
  virtual void pushed(const Block& block) const = 0;
  virtual void cut(const BlockCuts& cuts) const = 0;
  virtual void planned(const PlannedSegment& segment) const = 0;
  virtual void searched(const PlanSearch& search) const = 0;
  // So many blocks go to the classical plan instead: it is faster, or the search found nothing.
  virtual void took_classical(std::size_t blocks) const = 0;
};

}  // namespace kerf::lookahead
