// G6.2: gathers the blocks of one curve with knots in the text and checks it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "diagnostics/diagnostic_list.hpp"
#include "parser/curves/curve_block.hpp"

namespace kerf::parser {

// Two dialects share one machine:
//   Fanuc     G6.2 P K X Y Z R F, then K X Y Z R per control point, then P blocks with only K
//             (FANUC 15i operator's manual B-63324EN, NURBS interpolation)
//   LinuxCNC  the same with Q1..Q3 in the first block, the two axes of the plane only, and G6.2
//             repeated in the knot blocks
// A curve has n control points and n + P knots, of which the first P and the last P are equal. What
// can be told from one block is told there; the rest, at the latest, at the last knot block.
class NurbsCollector {
 public:
  [[nodiscard]] bool active() const { return active_; }
  // The block of the first control point.
  Done begin(const RunningBlock& at, const ModalState& state);
  // A further block. Precondition: active. It is not active after `complete` or a fault.
  Expected<CurveProgress> add(const RunningBlock& at, const ModalState& state);
  // Why the curve is not complete, where the text ends here.
  [[nodiscard]] diagnostics::Fault unfinished(std::uint32_t offset, std::string_view where) const;
  void abort() { active_ = false; }

  [[nodiscard]] NurbsMove take() { return std::move(curve_); }
  [[nodiscard]] const Point& last_point_mm() const { return last_point_mm_; }

 private:
  Done take_block(const RunningBlock& at, const ModalState& state);
  Done read_order(const RunningBlock& at);
  Done read_form(const RunningBlock& at);
  [[nodiscard]] Done check_foreign(const RunningBlock& at) const;
  Done check_axes(const RunningBlock& at, const ModalState& state);
  Done first_point(const RunningBlock& at, const ModalState& state);
  Done add_point(const RunningBlock& at, const ModalState& state);
  Done add_knot(const RunningBlock& at);
  [[nodiscard]] Done check_knot(const RunningBlock& at, double knot) const;
  [[nodiscard]] Done wrong_head(const RunningBlock& at, double knot) const;
  [[nodiscard]] Done check_tail(const RunningBlock& at) const;
  [[nodiscard]] Done check_whole(const RunningBlock& at) const;
  struct KnotOfLine {
    double knot = 0.0;
    std::uint32_t line = 0;
  };
  void push_knot(const KnotOfLine& given);

  NurbsMove curve_;
  Point last_point_mm_{};
  std::size_t order_ = 4;
  std::optional<diagnostics::DiagnosticPlace>
      extension_;              // P, where the order is above Fanuc's highest, 4
  std::size_t tail_ = 0;       // knot-only blocks so far
  std::size_t run_ = 0;        // equal knots at the end of the row so far
  Letters axes_ = 0;           // of the first block that has any
  bool in_plane_ = false;      // the LinuxCNC form
  bool knot_pending_ = false;  // the first block had no K
  bool active_ = false;
};

}  // namespace kerf::parser
