#include "tests/fuzz/judge/fuzz_input.hpp"

#include <array>
#include <string_view>

#include <kerf/machine.hpp>

#include "kernel/reader_options.hpp"
#include "profiles/profile.hpp"

namespace kerf::fuzz {
namespace {

constexpr std::array kProfiles{
    profiles::ProfileKind::time_optimal, profiles::ProfileKind::s_curve,
    profiles::ProfileKind::sigmoid,      profiles::ProfileKind::sine,
    profiles::ProfileKind::quintic,      profiles::ProfileKind::sine_series,
    profiles::ProfileKind::trapezoid};
constexpr std::array<std::size_t, 4> kWindows{64, 2, 3, 8};
constexpr std::array<std::string_view, 8> kModes{
    "",         "G61\n",           "G61.1\n", "G64\n", "G64 P0.01 Q0.005\n", "G64 P1 Q1\n",
    "G64 P0\n", "G64 P0.0001 Q0\n"};

// The default one, one whose axes are four decades apart, and one with limits along the path alone.
MachineSettings machine_of(std::uint8_t which) {
  MachineSettings machine = default_machine();
  if (which % 3 == 1) {
    machine.limits.axes[0].jerk_mm_s3 = 1e6;
    machine.limits.axes[1].acceleration_mm_s2 = 100.0;
    machine.limits.axes[2] = {
        .velocity_mm_s = 5.0, .acceleration_mm_s2 = 20.0, .jerk_mm_s3 = 100.0};
  } else if (which % 3 == 2) {
    machine.limits.axes = {};
    machine.limits.chord_tolerance_mm = 5e-4;
  }
  machine.limits.extra.fill(
      {.velocity_mm_s = 20.0, .acceleration_mm_s2 = 200.0, .jerk_mm_s3 = 5e3});
  return machine;
}

std::optional<parser::SubprogramText> subprogram(std::string_view name) {
  if (name != "ring") {
    return std::nullopt;
  }
  return parser::SubprogramText{"ring.ngc",
                                "o<ring> sub\nG91 G1 X#1 F100\nG90\no<ring> endsub [#1+1]\n"};
}

}  // namespace

std::optional<FuzzInput> fuzz_input(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHead) {
    return std::nullopt;
  }
  FuzzInput input;
  input.piece = std::size_t{1} + bytes[0];
  const std::uint8_t bits = bytes[1];
  const auto law = static_cast<std::uint8_t>(bytes[2] - '0');
  const auto way = static_cast<std::uint8_t>(bytes[3] - '0');
  input.machine = machine_of(static_cast<std::uint8_t>(way / kModes.size()));
  input.machine.program.extra_axes = (bits & 4) != 0 ? parser::kAuxiliaryLetters : 0;
  input.machine.dialect = (bits & 2) != 0 ? parser::Dialect::fanuc : parser::Dialect::rs274;
  input.kernel.profile = profiles::Profile(kProfiles[law % kProfiles.size()]);
  input.kernel.window_blocks = kWindows[law / kProfiles.size() % kWindows.size()];
  input.kernel.block_delete = (bits & 1) != 0 ? parser::BlockDelete::all() : parser::BlockDelete();
  input.kernel.subprograms = subprogram;
  input.reader = reader_options(input.machine, input.kernel);
  input.reader.max_idle_steps = 2000;
  const std::string_view mode = kModes[way % kModes.size()];
  input.text.reserve(mode.size() + bytes.size());
  input.text += mode;
  for (const std::uint8_t byte : bytes.subspan(kHead)) {
    input.text += static_cast<char>(byte);
  }
  return input;
}

}  // namespace kerf::fuzz
