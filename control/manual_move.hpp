// Motion by hand: a straight line, run by a kernel of its own.
#pragma once

#include <memory>
#include <string_view>

#include <kerf/controller.hpp>

namespace kerf::control {

inline constexpr std::string_view kNotHomed = "the axes are not homed: home first";

// Of all axes, in machine coordinates.
struct AxisTargets {
  Position mm{};
  AuxiliaryPosition extra_rad_mm{};

  friend bool operator==(const AxisTargets&, const AxisTargets&) = default;
};
[[nodiscard]] AxisTargets place_of(const Setpoint& at) noexcept;

struct ManualMove {
  AxisTargets to{};
  double mm_s = kUnbounded;  // of A, B, C alone deg/s; kUnbounded: as fast as the limits allow
};

// To where the jog leads at most: a continuous one to the end of the travel. Axes that are not
// homed have no travel. Or why it cannot be.
[[nodiscard]] tl::expected<ManualMove, std::string_view> move_of(const Jog& jog, const Setpoint& at,
                                                                 AxisSet unhomed,
                                                                 const MachineSettings& settings);

// From `at`, with the outputs there. It is fed and planned.
[[nodiscard]] std::unique_ptr<Kernel> kernel_of(const ManualMove& move, const Setpoint& at,
                                                const MachineSettings& settings,
                                                const KernelOptions& options);

}  // namespace kerf::control
