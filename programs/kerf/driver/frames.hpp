// What a machine is told and what it answers, as bytes: of a record, and of a machine in another
// process. docs/machine-interface.md has the layout.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "machine/machine.hpp"

namespace kerf::program {

enum class MachineCall : std::uint8_t { enable = 1, write = 2, disable = 3 };

// Of enable the setpoint has the places, of disable nothing.
struct ToldFrame {
  MachineCall call = MachineCall::write;
  Setpoint setpoint{};
};

[[nodiscard]] inline ToldFrame told_places(const machine::AxisPlaces& places) noexcept {
  return {.call = MachineCall::enable,
          .setpoint = {.position_mm = places.mm, .extra_rad_mm = places.extra_rad_mm}};
}

struct AnswerFrame {
  std::int64_t tick = 0;  // that it answers
  machine::MachineState state{};
};

inline constexpr std::uint32_t kFrameVersion = 1;
inline constexpr std::size_t kToldBytes = 320;
inline constexpr std::size_t kAnswerBytes = 384;
using ToldBytes = std::array<std::byte, kToldBytes>;
using AnswerBytes = std::array<std::byte, kAnswerBytes>;

// They allocate nothing and throw nothing. Nothing: these bytes are no such frame, for their
// length, first bytes, version, checksum, or a number that no enumeration has.
[[nodiscard]] ToldBytes to_bytes(const ToldFrame& frame) noexcept;
[[nodiscard]] AnswerBytes to_bytes(const AnswerFrame& frame) noexcept;
[[nodiscard]] std::optional<ToldFrame> told_from(std::span<const std::byte> bytes) noexcept;
[[nodiscard]] std::optional<AnswerFrame> answer_from(std::span<const std::byte> bytes) noexcept;

}  // namespace kerf::program
