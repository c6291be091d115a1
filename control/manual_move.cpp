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
constexpr std::size_t kRotary = 3;  // A, B, C come first among the further axes
constexpr std::size_t kAxes = kLinear + kAuxiliaryAxes;
constexpr std::string_view kLetters = "XYZABCUVW";
constexpr double kDegrees = 180.0 / 3.14159265358979323846;  // of a radian
// Of an axis without travel.
constexpr double kFarthest = 9e5;
// In mm/s or deg/s. Beyond the fastest only the limits bind.
constexpr double kSlowest = 1e-6;
constexpr double kFastest = 1e6;

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

bool is_rotary(std::size_t axis) {
  return axis >= kLinear && axis < kLinear + kRotary;
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
  const double further = norm(all.last(kAxes - kLinear - kRotary));
  return linear > 0.0    ? linear
         : further > 0.0 ? further
                         : kDegrees * norm(all.subspan(kLinear, kRotary));
}

bool is_in(AxisSet axes, std::size_t axis) {
  return ((axes >> axis) & 1U) != 0;
}

Travel travel_of(std::size_t axis, const MachineSettings& settings) {
  if (axis < kLinear) {
    return settings.table.axes[axis].travel;
  }
  const AuxiliaryTravel& travel = settings.table.extra[axis - kLinear];
  return {.min_mm = travel.min_rad_mm, .max_mm = travel.max_rad_mm};
}

// Of the travel, in that direction.
double end_of(std::size_t axis, bool above, AxisSet unhomed, const MachineSettings& settings) {
  const Travel travel = is_in(unhomed, axis) ? Travel{} : travel_of(axis, settings);
  return above ? std::min(travel.max_mm, kFarthest) : std::max(travel.min_mm, -kFarthest);
}

double fastest_of(std::size_t axis, AxisSet unhomed, const ManualSettings& settings) {
  return is_in(unhomed, axis) ? std::min(settings.jog_mm_s, settings.unhomed_jog_mm_s)
                              : settings.jog_mm_s;
}

// Empty: the axes may move so.
std::string_view refusal_of(const AxisValues& way, const Jog& jog, AxisSet unhomed,
                            const MachineSettings& settings) {
  const auto is_number = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(way, is_number) || !is_number(length_of(way))) {
    return "a value is out of its range";
  }
  if (length_of(way) == 0.0) {
    return "no axis is to move";
  }
  if (!((jog.is_step ? jog.step_mm_s : length_of(way)) >= kSlowest)) {
    return "a value is out of its range";
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (way[axis] != 0.0 && !has_axis(axis, settings)) {
      return "the machine has no such axis";
    }
    if (way[axis] != 0.0 && is_in(unhomed, axis) && settings.manual.unhomed_jog_mm_s == 0.0) {
      return kNotHomed;
    }
  }
  return {};
}

// Without an exponent, which G-code does not have, and exact.
void append_word(char letter, std::string& text, double value) {
  std::array<char, 512> digits{};  // a double has less than 400
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  text += letter;
  text.append(digits.data(), end.ptr);
}

std::string program_of(const ManualMove& move, const AxisTargets& from) {
  constexpr double kPerMinute = 60.0;
  std::string text = "G21 G90 G94 G61.1\n";
  const bool is_rapid = move.mm_s >= kFastest;
  text += is_rapid ? "G0" : "G1";
  const AxisValues to = values_of(move.to);
  const AxisValues begin = values_of(from);
  bool moves = false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (to[axis] != begin[axis]) {
      append_word(kLetters[axis], text, to[axis] * (is_rotary(axis) ? kDegrees : 1.0));
      moves = true;
    }
  }
  if (!moves) {
    return "G90\n";
  }
  if (!is_rapid) {
    append_word('F', text, kPerMinute * move.mm_s);
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
  if (const std::string_view why = refusal_of(way, jog, unhomed, settings); !why.empty()) {
    return tl::unexpected(why);
  }
  const AxisValues from = values_of(place_of(at));
  AxisValues ends{};
  double share = jog.is_step ? 1.0 : kUnbounded;  // of the way
  double fastest = jog.is_step ? jog.step_mm_s : length_of(way);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (way[axis] != 0.0) {
      ends[axis] = end_of(axis, way[axis] > 0.0, unhomed, settings);
      share = std::min(share, (ends[axis] - from[axis]) / way[axis]);
      fastest = std::min(fastest, fastest_of(axis, unhomed, settings.manual));
    }
  }
  if (!(share > 0.0)) {
    return tl::unexpected(std::string_view("an axis is at the end of its travel"));
  }
  AxisValues to{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    to[axis] = from[axis] + share * way[axis];
    if (way[axis] != 0.0) {  // rounding must not lead beyond
      to[axis] = way[axis] > 0.0 ? std::min(to[axis], ends[axis]) : std::max(to[axis], ends[axis]);
    }
  }
  return ManualMove{.to = targets_of(to), .mm_s = fastest};
}

std::unique_ptr<Kernel> kernel_of(const ManualMove& move, const Setpoint& at,
                                  const MachineSettings& settings, const KernelOptions& options) {
  MachineSettings plain{.limits = settings.limits, .table = settings.table};
  plain.program.extra_axes = settings.program.extra_axes;
  KernelOptions own{.profile = options.profile,
                    .window_blocks = options.window_blocks,
                    .horizon_s = options.horizon_s,
                    .start_mm = at.position_mm,
                    .start_extra_rad_mm = at.extra_rad_mm,
                    .start_outputs = at.outputs,
                    .one_line = true,
                    .dialect = Dialect::rs274,
                    .plan_log = options.plan_log,
                    .plan_clock = options.plan_clock};
  own.start_outputs.surface = {};  // the spindle does not follow
  auto kernel = std::make_unique<Kernel>(plain, own);
  kernel->feed(program_of(move, place_of(at)));
  kernel->finish();
  kernel->plan();
  return kernel;
}

}  // namespace kerf::control
