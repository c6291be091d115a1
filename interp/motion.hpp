// The data that crosses from the look-ahead to the tick side: geometry and time laws, as streams of
// trivially copyable values.
//
// q(t) = r(s(t)): a CurvePiece is a stretch of r, a Phase a stretch of s(t). Both name the curve
// they belong to by its number in the program, so neither needs to be cut where the other ends. The
// path never changes once it has crossed; phases that have not been run may be replaced by those of
// another plan. Lines and outputs therefore change by place, not by time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "curves/auxiliary_axis_motion.hpp"
#include "curves/curve.hpp"
#include "interp/constraint.hpp"
#include "profiles/time_law.hpp"

namespace kerf::interp {

struct CurvePiece {
  std::uint64_t curve = 0;
  curves::Piece geometry = curves::NurbsPiece{};
  curves::AuxiliaryAxisMotion extra{};  // along the whole curve
};

// From s_mm on, setpoints on this curve belong to the line.
struct LineChange {
  std::uint64_t curve = 0;
  double s_mm = 0.0;
  std::uint32_t line = 0;
  std::uint64_t run_block = 0;  // as Phase::run_block
};

// An instant as a whole number of ticks and a remainder, so that time keeps its precision however
// long a program runs.
struct TickTime {
  std::int64_t tick = 0;
  double offset_s = 0.0;  // in [0, period)
};

// One transition, cruise, rest or cell of the time optimum. The first phase after a rest begins on
// a tick.
struct Phase {
  std::uint64_t curve = 0;  // 0: a rest before the first motion
  TickTime begin{};
  double s_begin_mm = 0.0;     // on the curve
  double s_end_mm = 0.0;       // reached exactly when the law is over
  double path_begin_mm = 0.0;  // path length of all curves before this one
  profiles::TimeLaw law{};
  std::uint32_t line = 0;            // where it begins
  std::uint64_t run_block = 0;       // the run block where it begins, counted from 1; 0: a rest
  std::uint64_t rest_block = 0;      // of a rest, where the program has a block for it
  bool has_changes = false;          // LineChanges say where on the curve the line is another one
  std::uint64_t output_changes = 0;  // so many of the program's are in force from its begin on
  std::uint32_t plan = 0;            // counts the plans that took over from another one
  bool rapid = false;
  bool follows_feed = true;       // the operator's feed override
  bool follows_hold = true;       // a feed hold
  bool follows_adaptive = false;  // the machine's share of the feedrate
  bool heeds_feed_stop = true;    // of the machine
  double deviation_mm = 0.0;      // the largest of its block from the programmed path
  ActiveConstraint active_constraint{};
  bool ends_at_rest = false;
  bool holds = false;      // the rest at its end is a feed hold
  std::uint32_t wait = 0;  // counts the waits for an answer, of which its end is one; 0: it is none
  WaitCause wait_cause = WaitCause::none;
  bool ends_program = false;
};

// The phases of a new plan replace what is left of the one before. Where they begin, both have the
// tool at the same place, with the same feedrate and acceleration.
struct Takeover {
  std::uint32_t from = 0;  // the plan that it replaces
  std::uint32_t plan = 0;
  std::int64_t tick = 0;         // the first at or after their begin
  std::uint32_t phases_end = 0;  // MotionQueue::phases_pushed() after its phases to the rest
};

// A way to rest for a tick by which nothing else has come: the planning thread is late.
struct StopAhead {
  static constexpr std::size_t kPhases = 2048;

  std::uint32_t from = 0;
  std::uint32_t plan = 0;
  std::int64_t tick = 0;  // the first at or after its begin
  std::size_t count = 0;
  std::array<Phase, kPhases> phases{};
};

static_assert(std::is_trivially_copyable_v<CurvePiece>);
static_assert(std::is_trivially_copyable_v<LineChange>);
static_assert(std::is_trivially_copyable_v<Phase>);
static_assert(std::is_trivially_copyable_v<Takeover>);

}  // namespace kerf::interp
