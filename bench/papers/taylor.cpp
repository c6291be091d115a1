#include "bench/papers/taylor.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace kerf::bench {

namespace {

// Of the way's third differences; steps: what was gone from tick to tick.
double jerk_mm_s3(const std::vector<double>& steps_mm, double period_s) {
  double most = 0.0;
  // The last step is cut off where the curve ends.
  for (std::size_t i = 2; i + 1 < steps_mm.size(); ++i) {
    most = std::max(most, std::abs(steps_mm[i] - 2.0 * steps_mm[i - 1] + steps_mm[i - 2]));
  }
  return most / (period_s * period_s * period_s);
}

}  // namespace

TaylorRun taylor_of(const MotionRun& run, const ParametricCurve& curve, double period_s) {
  const auto& by_length = std::get<curves::NurbsCurve>(run.block.curve);
  TaylorRun found;
  const Setpoint& first = run.on_curve.front().setpoint;
  const curves::NurbsPiece& piece = by_length.pieces()[by_length.piece_index(first.s_mm)];
  double u = piece.u_at(first.s_mm);
  double s = first.s_mm;
  std::vector<double> arcs;
  std::vector<double> chords;
  for (std::size_t i = 1; i < run.on_curve.size() && u < curve.u_end(); ++i) {
    const Setpoint& to = run.on_curve[i].setpoint;
    const double next = curve.step(u, to.s_mm - run.on_curve[i - 1].setpoint.s_mm);
    const double s_next = by_length.s_at(next);
    arcs.push_back(s_next - s);
    chords.push_back((curve.position_mm(next) - curve.position_mm(u)).norm());
    u = next;
    s = s_next;
    found.drift_mm = std::max(found.drift_mm, std::abs(s - to.s_mm));
  }
  found.arc_jerk_mm_s3 = jerk_mm_s3(arcs, period_s);
  found.chord_jerk_mm_s3 = jerk_mm_s3(chords, period_s);
  return found;
}

}  // namespace kerf::bench
