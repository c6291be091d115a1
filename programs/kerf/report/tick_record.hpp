// The data of one tick for traces and plots.
#pragma once

#include <cstdint>
#include <type_traits>

#include <kerf/kernel.hpp>

#include "interp/constraint.hpp"
#include "interp/setpoint.hpp"
#include "machine/machine.hpp"
#include "profiles/shape_value.hpp"

namespace kerf::program {

// What the machine does from a tick to the next.
enum class TickKind : std::uint8_t { rest, rapid, cut };

struct TickRecord {
  std::int64_t tick = 0;
  std::uint32_t line = 0;
  bool rapid = false;
  std::int32_t tool = 0;  // in the spindle
  interp::Constraint limit{};
  profiles::PathMotion motion{};
  curves::Position position_mm{};
  curves::Position actual_mm{};
  curves::AuxiliaryPosition extra_rad_mm{};
  TickDetail detail{};
};
static_assert(std::is_trivially_copyable_v<TickRecord>);

inline TickKind kind_of(const TickRecord& record) noexcept {
  if (record.limit == interp::Constraint::rest) {
    return TickKind::rest;
  }
  return record.rapid ? TickKind::rapid : TickKind::cut;
}

inline TickRecord record_of(const interp::Setpoint& setpoint, const TickDetail& detail,
                            const machine::MachineState& state) noexcept {
  return {.tick = setpoint.tick,
          .line = setpoint.line,
          .rapid = setpoint.rapid,
          .tool = setpoint.outputs.tool,
          .limit = setpoint.limit,
          .motion = {.s_mm = setpoint.s_mm,
                     .v_mm_s = setpoint.v_mm_s,
                     .a_mm_s2 = setpoint.a_mm_s2,
                     .j_mm_s3 = setpoint.j_mm_s3},
          .position_mm = setpoint.position_mm,
          .actual_mm = state.actual_mm,
          .extra_rad_mm = setpoint.extra_rad_mm,
          .detail = detail};
}

}  // namespace kerf::program
