// The figures of a plan and of a run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <kerf/axes.hpp>

namespace kerf {
inline namespace v0 {

/// Largest figures of velocity, acceleration and jerk.
struct Peaks {
  double v_mm_s = 0.0;
  double a_mm_s2 = 0.0;
  double j_mm_s3 = 0.0;
};

/// The largest figures of a run so far, from differences of its setpoints.
struct RunFigures {
  Peaks path{};
  std::array<Peaks, 3> axes{};
  std::array<Peaks, kAuxiliaryAxes> extra{};  ///< A, B, C in rad
  double chord_error_mm = 0.0;
};

/// A promise that does not hold: a defect of kerf, not of the program.
struct RunFault {
  std::uint32_t line = 0;  ///< of the program; 0: none is known
  std::string what;
};

/// How far the commanded path is from the programmed one: the largest distance, in either
/// direction, and its place on the commanded path.
struct PathDeviation {
  double distance_mm = 0.0;
  Position at_mm{};
  std::uint32_t line = 0;
  double tolerance_mm = 0.0;  ///< P or Q in force there
};

/// Where a plan is slower than its profile promises.
struct PlanDegradation {
  enum class Kind : unsigned char {
    slower,     ///< up to its next stop the motion keeps its limits, but could be faster
    classical,  ///< up to its next stop it follows the plan of a classical profile
    stop        ///< the motion comes to rest there though the path does not ask for it
  };

  std::uint32_t line = 0;
  double s_mm = 0.0;  ///< from the line's begin: of the stop, or where the slower motion begins
  Kind kind = Kind::slower;
};

/// All are counted, the first ones kept: memory does not grow with a program's length.
struct PlanDegradations {
  std::uint64_t count = 0;
  std::array<PlanDegradation, 8> first{};

  [[nodiscard]] std::size_t kept() const noexcept {
    return count < first.size() ? static_cast<std::size_t>(count) : first.size();
  }
};

/// Where a program rests for somebody or something: M0, M1, M6, M60, and M3 or M4 where starting
/// the spindle takes time.
struct PlanWait {
  enum class Kind : unsigned char {
    program_stop,
    optional_stop,
    pallet_change,
    tool_change,
    spindle_start
  };
  std::uint32_t line = 0;
  Kind kind = Kind::program_stop;
  std::int32_t tool = 0;    ///< of a tool change
  double duration_s = 0.0;  ///< that the machine takes; 0: none, or until somebody answers
};

/// All are counted, the first ones kept.
struct PlanWaits {
  std::uint64_t count = 0;
  double duration_s = 0.0;  ///< of all
  std::array<PlanWait, 8> first{};
};

/// What was planned so far.
struct PlanTotals {
  std::uint64_t blocks = 0;
  std::uint64_t segments = 0;
  double path_length_mm = 0.0;
  std::int64_t ticks = 0;
  PlanDegradations degradations{};
};

}  // namespace v0
}  // namespace kerf
