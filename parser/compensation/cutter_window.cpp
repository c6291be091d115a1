// The moves that are held, and how they leave.
#include <algorithm>

#include "parser/compensation/cutter_compensation.hpp"

namespace kerf::parser {

// Not so where an error has left out moves; then there is no corner to speak of.
bool CutterCompensation::goes_on_at(const Point& start_mm) {
  constexpr double kGap_mm = 1e-3;
  HeldMove* const last = last_curve();
  if (last == nullptr ||
      length(last->curve.programmed.end_mm - sender_.in_plane(start_mm)) < kGap_mm) {
    return true;
  }
  settle(*last);
  send_all();
  ++run_;
  return false;
}

HeldMove* CutterCompensation::last_curve() {
  const auto last = std::find_if(held_.rbegin(), held_.rend(), [](const HeldMove& held) {
    return held.role == HeldRole::entry || held.role == HeldRole::contour;
  });
  return last != held_.rend() ? &*last : nullptr;
}

void CutterCompensation::send_surplus() {
  while (curves_ > kWindow + 1) {
    curves_ -= held_.front().role != HeldRole::idle ? 1U : 0U;
    send(held_.front());
    held_.pop_front();
  }
}

void CutterCompensation::send_all() {
  for (const HeldMove& held : held_) {
    send(held);
  }
  held_.clear();
  curves_ = 0;
}

void CutterCompensation::send(const HeldMove& held) {
  if (held.fault) {
    faults_.push_back(*held.fault);
  }
  if (!held.left_out) {
    sender_.send(held);
  }
}

void CutterCompensation::forget_faults() {
  for (HeldMove& held : held_) {
    held.fault.reset();
  }
}

}  // namespace kerf::parser
