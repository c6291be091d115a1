#include "control/manual_move.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

namespace kerf::control {

namespace {

constexpr std::size_t kLinear = 3;
constexpr std::size_t kTurning = 3;  // A, B, C come first among the further axes
constexpr std::size_t kAxes = kLinear + kAuxiliaryAxes;
constexpr std::string_view kLetters = "XYZABCUVW";
constexpr double kDegrees = 180.0 / 3.14159265358979323846;  // of a radian
// Of an axis without travel.
constexpr double kFarthest = 9e5;

using AxisValues = std::array<double, kAxes>;

AxisValues values_of(const AxisTargets& place) {
  AxisValues values{};
  std::ranges::copy(place.mm, values.begin());
  std::ranges::copy(place.extra_rad_mm, values.begin() + kLinear);
  return values;
}

AxisTargets targets_of(const AxisValues& values) {
  AxisTargets place;
  std::copy_n(values.begin(), kLinear, place.mm.begin());
  std::copy_n(values.begin() + kLinear, kAuxiliaryAxes, place.extra_rad_mm.begin());
  return place;
}

bool turns(std::size_t axis) {
  return axis >= kLinear && axis < kLinear + kTurning;
}

bool has_axis(std::size_t axis, const MachineSettings& settings) {
  return axis < kLinear || (settings.program.extra_axes & letter_bit(kLetters[axis])) != 0;
}

double norm(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value * value;
  }
  return std::sqrt(sum);
}

// What F counts along: X, Y, Z; where none of them moves U, V, W; else A, B, C in degrees.
double length_of(const AxisValues& way) {
  const std::span all(way);
  const double linear = norm(all.first(kLinear));
  const double further = norm(all.last(kAxes - kLinear - kTurning));
  return linear > 0.0    ? linear
         : further > 0.0 ? further
                         : kDegrees * norm(all.subspan(kLinear, kTurning));
}

// The end of the travel in that direction.
double end_of(std::size_t axis, bool above, const MachineSettings& settings) {
  if (axis < kLinear) {
    const Travel& travel = settings.table.axes[axis].travel;
    return above ? travel.max_mm : travel.min_mm;
  }
  const AuxiliaryTravel& travel = settings.table.extra[axis - kLinear];
  return above ? travel.max_rad_mm : travel.min_rad_mm;
}

// Without an exponent, which G-code does not have, and exact.
void append_word(char letter, double value, std::string& text) {
  std::array<char, 512> digits{};  // a double has less than 400
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  text += letter;
  text.append(digits.data(), end.ptr);
}

std::string program_of(const ManualMove& move, const AxisTargets& from) {
  constexpr double kPerMinute = 60.0;
  std::string text = "G21 G90 G94 G61.1\n";
  text += move.mm_s == kUnbounded ? "G0" : "G1";
  const AxisValues to = values_of(move.to);
  const AxisValues begin = values_of(from);
  bool moves = false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (to[axis] != begin[axis]) {
      append_word(kLetters[axis], to[axis] * (turns(axis) ? kDegrees : 1.0), text);
      moves = true;
    }
  }
  if (!moves) {
    return "G90\n";
  }
  if (move.mm_s != kUnbounded) {
    append_word('F', kPerMinute * move.mm_s, text);
  }
  return text + "\n";
}

}  // namespace

AxisTargets place_of(const Setpoint& at) noexcept {
  return {.mm = at.position_mm, .extra_rad_mm = at.extra_rad_mm};
}

tl::expected<ManualMove, std::string_view> move_of(const Jog& jog, const Setpoint& at,
                                                   AxisSet unhomed,
                                                   const MachineSettings& settings) {
  const AxisValues way = values_of({.mm = jog.mm, .extra_rad_mm = jog.extra_rad_mm});
  const double length = length_of(way);
  const auto is_number = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(way, is_number) || !std::isfinite(length) || !(jog.step_mm_s > 0.0)) {
    return tl::unexpected(std::string_view("a value is out of its range"));
  }
  if (length == 0.0) {
    return tl::unexpected(std::string_view("no axis is to move"));
  }
  const AxisValues from = values_of(place_of(at));
  AxisValues ends{};
  double share = jog.is_step ? 1.0 : kUnbounded;  // of the way
  double fastest = settings.manual.jog_mm_s;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (way[axis] == 0.0) {
      continue;
    }
    if (!has_axis(axis, settings)) {
      return tl::unexpected(std::string_view("the machine has no such axis"));
    }
    const bool is_homed = ((unhomed >> axis) & 1U) == 0;
    if (!is_homed && settings.manual.unhomed_jog_mm_s == 0.0) {
      return tl::unexpected(kNotHomed);
    }
    fastest = is_homed ? fastest : std::min(fastest, settings.manual.unhomed_jog_mm_s);
    const bool above = way[axis] > 0.0;
    const double end = is_homed ? end_of(axis, above, settings) : kUnbounded;
    ends[axis] = std::isfinite(end) ? end : (above ? kFarthest : -kFarthest);
    share = std::min(share, (ends[axis] - from[axis]) / way[axis]);
  }
  if (!(share > 0.0)) {
    return tl::unexpected(std::string_view("an axis is at the end of its travel"));
  }
  AxisValues to = from;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (way[axis] != 0.0) {
      const double target = from[axis] + share * way[axis];
      to[axis] = way[axis] > 0.0 ? std::min(target, ends[axis]) : std::max(target, ends[axis]);
    }
  }
  return ManualMove{.to = targets_of(to),
                    .mm_s = std::min(fastest, jog.is_step ? jog.step_mm_s : length)};
}

std::unique_ptr<Kernel> kernel_of(const ManualMove& move, const Setpoint& at,
                                  const MachineSettings& settings, const KernelOptions& options) {
  MachineSettings plain = settings;
  plain.program = {};
  plain.program.extra_axes = settings.program.extra_axes;
  KernelOptions own{.profile = options.profile,
                    .window_blocks = options.window_blocks,
                    .horizon_s = options.horizon_s,
                    .start_mm = at.position_mm,
                    .start_extra_rad_mm = at.extra_rad_mm,
                    .start_outputs = at.outputs,
                    .one_line = true,
                    .dialect = Dialect::rs274,
                    .plan_log = options.plan_log};
  own.start_outputs.surface = {};  // the spindle does not follow
  auto kernel = std::make_unique<Kernel>(plain, own);
  kernel->feed(program_of(move, place_of(at)));
  kernel->finish();
  kernel->plan();
  return kernel;
}

}  // namespace kerf::control
