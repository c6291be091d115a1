// Checks each setpoint against the limits.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <kerf/report.hpp>

#include "curves/auxiliary_axis_motion.hpp"
#include "curves/position.hpp"
#include "interp/setpoint.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf {

// A figure of one tick that is above what it may be.
struct TickExcess {
  enum class Figure : std::uint8_t {
    none,
    velocity,
    acceleration,
    jerk,
    chord_error,
    end,  // the distance between the last tick and the programmed end
    not_finite
  };
  static constexpr std::int8_t kPath = -1;

  Figure figure = Figure::none;
  std::int8_t axis = kPath;  // X, Y, Z, A, B, C, U, V, W from 0 on
  std::uint32_t line = 0;
  std::int64_t tick = 0;
  double found = 0.0;  // in mm and s, of A, B, C in rad
  double limit = 0.0;
};

// Nothing: no excess.
std::optional<RunFault> describe(const TickExcess& excess);

// Where the tool is.
struct PlaceOfTool {
  curves::Position position_mm{};
  curves::AuxiliaryPosition extra_rad_mm{};
};

// Figures along the path come from the arc length between ticks, those of the axes from positions,
// both by finite differences: what a drive sees, not what the plan states. Each may exceed its
// limit by a relative 1e-6 plus the rounding error of the differences; a chord by 0.5 % of its
// tolerance. Real time: add() allocates nothing, takes no lock, throws nothing.
class TickJudge {
 public:
  // binds_jerk: false for a profile without a jerk limit. has_extra_axes: A, B, C, U, V and W are
  // checked too.
  struct Settings {
    lookahead::PlanLimits limits{};
    bool binds_jerk = true;
    bool has_extra_axes = false;
  };

  explicit TickJudge(const Settings& settings);

  void add(const interp::Setpoint& setpoint, double chord_error_mm) noexcept;

  // The tick before this one found nothing planned: its position says nothing about the plan, so
  // differences that include it are skipped.
  void starve() noexcept { settling_ = kDifferences + 1; }

  // Call with the program's last tick. Moves shorter than the program's resolution may be left out.
  void judge_end(const interp::Setpoint& last, const PlaceOfTool& programmed) noexcept;

  // The first excess found; its figure is `none` while there is none.
  [[nodiscard]] const TickExcess& excess() const noexcept { return excess_; }
  [[nodiscard]] Peaks path() const noexcept { return peaks_of(path_); }
  [[nodiscard]] std::array<Peaks, 3> axes() const noexcept;
  // Of A, B, C in rad.
  [[nodiscard]] std::array<Peaks, curves::kAuxiliaryAxes> extra_axes() const noexcept;
  // The largest so far, and that of the latest tick.
  [[nodiscard]] double chord_error_mm() const noexcept { return chord_error_mm_; }
  [[nodiscard]] double latest_chord_error_mm() const noexcept { return latest_chord_error_mm_; }
  [[nodiscard]] RunFigures figures() const noexcept {
    return {
        .path = path(), .axes = axes(), .extra = extra_axes(), .chord_error_mm = chord_error_mm_};
  }

 private:
  static constexpr int kDifferences = 3;

  // One coordinate: its last three values, newest first, the largest of its first, second and third
  // differences, and what they may be.
  struct Track {
    std::array<double, 3> x{};
    std::array<double, 3> most{};
    lookahead::MotionLimits limits{};
    std::int8_t axis = TickExcess::kPath;
  };
  struct Tick {
    double x = 0.0;
    std::array<double, 3> differences{};
  };

  void add(Track& track, double x, const interp::Setpoint& at) noexcept;
  void raise(Track& track, const Tick& now, const interp::Setpoint& at) noexcept;
  [[nodiscard]] Peaks peaks_of(const Track& track) const noexcept;
  void judge(const TickExcess& found, double rounding) noexcept;

  std::array<double, 3> time_;  // the period, its square and its cube
  double chord_tolerance_mm_;
  bool binds_jerk_;
  bool has_extra_axes_;
  bool began_ = false;
  int settling_ = 0;  // ticks whose differences are skipped
  Track path_{};
  std::array<Track, 3> axes_{};
  std::array<Track, curves::kAuxiliaryAxes> extra_{};
  double chord_error_mm_ = 0.0;
  double latest_chord_error_mm_ = 0.0;
  TickExcess excess_{};
};

}  // namespace kerf
