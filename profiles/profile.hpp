// A feedrate law by name: the fastest transition it allows, how far it reaches, and the cruise
// that two transitions leave room for.
#pragma once

#include <optional>

#include <kerf/profile.hpp>

#include "profiles/reach.hpp"
#include "profiles/transition.hpp"

namespace kerf::profiles {

using kerf::kDefaultProfile;
using kerf::name_of;
using kerf::profile_kind;
using kerf::ProfileKind;

// The length and the highest feedrate for two transitions with a cruise between them.
struct Room {
  double length_mm = 0.0;   // >= 0
  double v_cap_mm_s = 0.0;  // the cruise is not to be faster; may be infinite
};

class Profile {
 public:
  // sigmoid_shape fixes s of the sigmoid, within Sigmoid's domain (clamped to it); without it s is
  // chosen for each transition. The other laws ignore it.
  explicit Profile(ProfileKind kind, std::optional<double> sigmoid_shape = std::nullopt);

  explicit Profile(const ProfileChoice& choice) : Profile(choice.kind, choice.sigmoid_shape) {}
  // NOLINTNEXTLINE(google-explicit-constructor): a profile is its choice wherever one is needed
  operator ProfileChoice() const { return {.kind = kind_, .sigmoid_shape = sigmoid_shape_}; }

  [[nodiscard]] ProfileKind kind() const noexcept { return kind_; }
  [[nodiscard]] std::optional<double> sigmoid_shape() const noexcept { return sigmoid_shape_; }

  // The shortest duration of a change of feedrate by change_mm_s (either sign): docs/math.md, 2.1,
  // T = max(a* |dv| / A, sqrt(j* |dv| / J)). The trapezoid does not know jerk. 0 where no limit
  // binds.
  [[nodiscard]] double duration_s(double change_mm_s, const RampLimits& limits) const;
  // The length of the transition of that duration; exactly fastest().length_mm().
  [[nodiscard]] double length_mm(const Ramp& ramp, const RampLimits& limits) const;
  // The transition of that duration.
  [[nodiscard]] Transition fastest(const Ramp& ramp, const RampLimits& limits) const;

  // The largest feedrate >= approach.v_mm_s that a transition from there attains within
  // approach.length_mm. By symmetry also the largest from which v_mm_s is attained. Never too
  // large: length_mm of the transition to the answer is not above approach.length_mm, and the
  // answer is within some units in the last place of the largest double of which that is true.
  // approach.v_cap_mm_s where that is attained; infinite where neither it nor a limit binds.
  [[nodiscard]] double reach_mm_s(const Approach& approach, const RampLimits& limits) const;

  // The largest cruise feedrate in [max(ends), room.v_cap_mm_s] so that the transitions from
  // ends.v_begin_mm_s up to it and from it down to ends.v_end_mm_s fit into room.length_mm
  // together. Preconditions: the direct transition between the ends fits, and neither end is above
  // the cap; where the direct transition misses by rounding the answer is max(ends). Never too
  // large in the sense of reach_mm_s.
  [[nodiscard]] double peak_mm_s(const Ramp& ends, const Room& room,
                                 const RampLimits& limits) const;

 private:
  // Before rounding down; of the cruise, its rise above the faster end.
  [[nodiscard]] double reachable_change(const Approach& approach, const RampLimits& limits) const;
  [[nodiscard]] double cruise_rise(const Ramp& ends, const Room& room,
                                   const RampLimits& limits) const;
  // Of both transitions, to the cruise and from it.
  [[nodiscard]] double length_over_mm(const Ramp& ends, double cruise_mm_s,
                                      const RampLimits& limits) const;

  ProfileKind kind_;
  std::optional<double> sigmoid_shape_;
};

}  // namespace kerf::profiles
