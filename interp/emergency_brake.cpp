#include "interp/emergency_brake.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::interp {

namespace {

// Of a tick. Where a bend tightens, a motion that is a little too fast has less to brake with, and
// is the faster for it: what a step rounds grows from there on.
constexpr int kSteps = 16;
constexpr double kAim = 0.9998;  // of an axis' limit, where the path bends
// Where it can only speed up within the limit: by less than the plan does, so as to stay below it.
constexpr double kYield = 1.0005;

// The largest d with |second v^2 - first d| <= most. Below 0 where the bend alone takes more than
// the axis has: only speeding up takes that back, as the plan does there.
double within(double first, double centripetal, double most) noexcept {
  if (first == 0.0) {
    return kUnbounded;
  }
  const double bend = std::copysign(centripetal, first * centripetal);
  const double aim = centripetal != 0.0 ? kAim * most : most;
  if (aim + bend >= 0.0) {
    return (aim + bend) / std::abs(first);
  }
  return std::min(kYield * most + bend, 0.0) / std::abs(first);
}

}  // namespace

double EmergencyBrake::deceleration_mm_s2(const Motion& motion) const noexcept {
  const curves::AuxiliaryAxisMotion& extra = motion.piece.extra;
  double most = kUnbounded;
  for (std::size_t k = 0; k < kAuxiliaryAxes; ++k) {
    most = std::min(most, within(extra.slope_per_mm(k), 0.0, limits_.extra[k].acceleration_mm_s2));
  }
  if (extra.alone) {
    return most;
  }
  most = std::min(most, limits_.path.acceleration_mm_s2);
  const curves::PathDerivatives path = curves::derivatives_at(motion.piece.geometry, motion.s_mm);
  for (std::size_t k = 0; k < limits_.axes.size(); ++k) {
    const double centripetal = path.second_per_mm[k] * motion.v_mm_s * motion.v_mm_s;
    most = std::min(most, within(path.first[k], centripetal, limits_.axes[k].acceleration_mm_s2));
  }
  return std::max(most, -limits_.path.acceleration_mm_s2);
}

// At the end of the path that is known it stays.
void EmergencyBrake::follow_path(Motion& motion, MotionQueue& queue) noexcept {
  for (std::size_t i = 0; i < MotionQueue::kPieces; ++i) {
    const double end_mm = curves::s_end_mm(motion.piece.geometry);
    if (motion.s_mm <= end_mm) {
      return;
    }
    const CurvePiece* next = queue.next_piece();
    if (next == nullptr) {
      motion.s_mm = end_mm;
      motion.v_mm_s = 0.0;
      return;
    }
    if (next->curve != motion.piece.curve) {
      motion.s_mm -= end_mm;
      motion.path_begin_mm += motion.piece.extra.alone ? 0.0 : end_mm;
    }
    motion.piece = *next;
    queue.pop_piece();
  }
}

// The deceleration in the middle of the step holds for all of it.
void EmergencyBrake::step(Motion& motion, MotionQueue& queue, double step_s) const noexcept {
  const double v = motion.v_mm_s;
  if (v == 0.0) {
    return;
  }
  const double half_s = 0.5 * step_s;
  Motion middle = motion;
  middle.v_mm_s = std::max(v - deceleration_mm_s2(motion) * half_s, 0.0);
  middle.s_mm = std::min(motion.s_mm + 0.5 * (v + middle.v_mm_s) * half_s,
                         curves::s_end_mm(motion.piece.geometry));
  const double deceleration = deceleration_mm_s2(middle);
  motion.a_mm_s2 = -deceleration;
  motion.v_mm_s = std::max(v - deceleration * step_s, 0.0);
  motion.s_mm +=
      motion.v_mm_s > 0.0 ? 0.5 * (v + motion.v_mm_s) * step_s : 0.5 * v * v / deceleration;
  follow_path(motion, queue);
}

void EmergencyBrake::advance(Motion& motion, MotionQueue& queue) const noexcept {
  motion.a_mm_s2 = 0.0;
  if (motion.piece.curve == 0) {
    motion.v_mm_s = 0.0;
  }
  for (int i = 0; i < kSteps; ++i) {
    step(motion, queue, period_s_ / kSteps);
  }
}

}  // namespace kerf::interp
