// A part of s(t): a transition of a profile, a cruise, a rest, or a cell of the time optimum.
#pragma once

#include <type_traits>
#include <variant>

#include "profiles/cell_law.hpp"
#include "profiles/transition.hpp"

namespace kerf::profiles {

class TimeLaw {
 public:
  TimeLaw() = default;
  // A law is one of its kinds, so the conversions need no name.
  // NOLINTNEXTLINE(google-explicit-constructor)
  TimeLaw(const Transition& law) : law_(law) {}
  // NOLINTNEXTLINE(google-explicit-constructor)
  TimeLaw(const CellLaw& law) : law_(law) {}

  [[nodiscard]] double duration_s() const noexcept {
    return is_cell() ? cell().duration_s() : transition().duration_s();
  }
  [[nodiscard]] double length_mm() const noexcept {
    return is_cell() ? cell().length_mm() : transition().length_mm();
  }
  // The feedrates at its ends.
  [[nodiscard]] Ramp ramp() const noexcept {
    return is_cell()
               ? Ramp{.v_begin_mm_s = cell().v_begin_mm_s(), .v_end_mm_s = cell().v_end_mm_s()}
               : transition().ramp();
  }
  // Motion t_s after the start, s from 0; t_s outside [0, duration] is clamped.
  [[nodiscard]] PathMotion at(double t_s) const noexcept {
    return is_cell() ? cell().at(t_s) : transition().at(t_s);
  }

 private:
  [[nodiscard]] bool is_cell() const noexcept { return std::holds_alternative<CellLaw>(law_); }
  [[nodiscard]] const CellLaw& cell() const noexcept { return *std::get_if<CellLaw>(&law_); }
  [[nodiscard]] const Transition& transition() const noexcept {
    return *std::get_if<Transition>(&law_);
  }

  std::variant<Transition, CellLaw> law_{};
};

static_assert(std::is_trivially_copyable_v<TimeLaw>);

}  // namespace kerf::profiles
