// G5.2 ... G5.3: gathers the control points of a curve whose knots are built in.
#pragma once

#include <string>

#include "parser/curves/curve_block.hpp"

namespace kerf::parser {

// LinuxCNC's form: `G5.2 P L [X Y]`, then `X Y P` per control point, closed by G5.3. The current
// position is the first control point, P is a weight (1 where left out), L the order (3 where left
// out), the axes are the two of the plane. The knots are clamped and uniform: L zeros, 1, 2, ...,
// and L times the last whole number. Orders below 3, which LinuxCNC takes for 3, are refused.
class UniformCollector {
 public:
  [[nodiscard]] bool active() const { return active_; }
  Done begin(const RunningBlock& at, const ModalState& state);
  // Precondition: active. It is not active after `complete` or a fault.
  Expected<CurveProgress> add(const RunningBlock& at, const ModalState& state);
  [[nodiscard]] diagnostics::Fault unfinished(std::uint32_t offset, std::string_view where) const;
  void abort() { active_ = false; }

  [[nodiscard]] NurbsMove take() { return std::move(curve_); }
  [[nodiscard]] const Point& last_point_mm() const { return last_point_mm_; }

 private:
  Done take_block(const RunningBlock& at, const ModalState& state);
  Done read_order(const RunningBlock& at);
  [[nodiscard]] Done check_foreign(const RunningBlock& at) const;
  Done add_point(const RunningBlock& at, const ModalState& state);
  Done close(const RunningBlock& at);
  void make_knots(std::uint32_t line);

  NurbsMove curve_;
  Point last_point_mm_{};
  std::size_t order_ = 3;
  bool active_ = false;
};

}  // namespace kerf::parser
