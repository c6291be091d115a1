// The limit that binds in each part of a segment of the classical schedule.
#pragma once

#include "lookahead/classical/velocity_segment.hpp"

namespace kerf::lookahead {

using interp::ActiveConstraint;

enum class SegmentPart : std::uint8_t {
  begin_constant_velocity,
  acceleration,
  cruise,
  deceleration,
  end_constant_velocity
};

// - A part at constant velocity serves a junction, or waits at the low end of a limit curve.
// - A cruise runs at the feedrate that its block allows, or below a limit curve.
// - A change of feedrate is bound by jerk and acceleration, each in its own part; where the profile
//   has both at once, by the one of which a hundredth more would save more time. Where it was
//   stretched to stay below a limit curve or to leave room for curvature, that limit binds.
class SegmentConstraint {
 public:
  struct Settings {
    const Block* block = nullptr;
    const VelocitySegment* segment = nullptr;  // of the block
    const profiles::Profile* profile = nullptr;
    bool brakes_for_window = false;  // the segment after it is not known yet
  };
  // Lives no longer than what the settings point to.
  explicit SegmentConstraint(const Settings& settings) : of_(settings) {}

  // s_begin_mm: of the part, on the block's curve.
  [[nodiscard]] ActiveConstraint of(SegmentPart part, const profiles::Transition& law,
                                    double s_begin_mm) const;

 private:
  [[nodiscard]] ActiveConstraint constant_velocity(double constant_velocity_s,
                                                   const profiles::Transition& law,
                                                   double s_begin_mm) const;
  [[nodiscard]] ActiveConstraint cruise(const profiles::Transition& law, double s_begin_mm) const;
  [[nodiscard]] ActiveConstraint ramp(const profiles::Transition& law, double s_begin_mm) const;
  // Null: curvature does not bind.
  [[nodiscard]] const PathSample* axis_limit_at(double s_mm) const;
  // The origin of the limit curve (of the block or of curvature) at the place where the law is
  // nearest to it.
  [[nodiscard]] ActiveConstraint limit_curve(const profiles::Transition& law,
                                             double s_begin_mm) const;

  Settings of_;
};

}  // namespace kerf::lookahead
