#include <algorithm>
#include <cmath>
#include <string_view>

#include <kerf/check.hpp>

#include "interp/setpoint.hpp"
#include "lookahead/path/limits.hpp"
#include "tests/fuzz/judge/judge.hpp"
#include "tests/fuzz/judge/verdict.hpp"

namespace kerf::fuzz {
namespace {

constexpr std::int64_t kTicksBeforeStop = 5000;
constexpr std::int64_t kTicksOfStop = 20'000;
constexpr std::int64_t kMostTicks = 1'000'000;
constexpr double kFarthest_mm = 1e7;

template <class List>
bool all_within(const List& list, double most) {
  return std::all_of(list.begin(), list.end(),
                     [most](double value) { return std::fabs(value) <= most; });
}

// An axis goes no farther in a tick than its limit and that of the path let it.
bool may_follow(const interp::Setpoint& before, const interp::Setpoint& now,
                const lookahead::PlanLimits& limits) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double fastest_mm_s =
        std::min(limits.axes[axis].velocity_mm_s, limits.path.velocity_mm_s);
    const double way_mm = std::fabs(now.position_mm[axis] - before.position_mm[axis]);
    if (way_mm > fastest_mm_s * limits.period_s * (1.0 + 1e-6) + 1e-8) {
      return false;
    }
  }
  return true;
}

void judge_tick(const interp::Setpoint& before, const interp::Setpoint& now,
                const lookahead::PlanLimits& limits) {
  require(all_within(now.position_mm, kFarthest_mm), "a position is finite");
  require(all_within(now.extra_rad_mm, kFarthest_mm), "a further axis is finite");
  require(std::isfinite(now.s_mm) && std::isfinite(now.v_mm_s) && std::isfinite(now.a_mm_s2) &&
              std::isfinite(now.j_mm_s3),
          "the motion along the path is finite");
  require(may_follow(before, now, limits), "no axis is faster than its limit");
}

CheckReport checked(const FuzzInput& input) {
  bool given = false;
  const auto text = [&]() -> std::string_view {
    return std::exchange(given, true) ? std::string_view{} : std::string_view(input.text);
  };
  return check_program(text, input.machine, input.kernel);
}

// Within a tap (G84, G74) a stop waits for its end, which the programmed time bounds.
std::int64_t ticks_of_stop(const FuzzInput& input, const CheckReport& report) {
  const bool may_tap = input.text.find("84") != std::string_view::npos ||
                       input.text.find("74") != std::string_view::npos;
  const double programmed =
      (report.nominal.motion_s + report.nominal.rest_s) / input.machine.limits.period_s;
  return kTicksOfStop + (may_tap && programmed > 0.0
                             ? static_cast<std::int64_t>(std::min(programmed, 1.0 * kMostTicks))
                             : 0);
}

}  // namespace

void judge_motion(const FuzzInput& input, const EndPoint& end) {
  const CheckReport report = checked(input);
  Kernel kernel(input.machine, input.kernel);
  kernel.feed(input.text);
  kernel.finish();
  interp::Setpoint before;
  interp::Setpoint now;
  auto status = interp::TickStatus::running;
  bool stopped = false;
  std::int64_t ticks = 0;
  const std::int64_t most = kTicksBeforeStop + ticks_of_stop(input, report);
  for (; status == interp::TickStatus::running; ++ticks) {
    if (ticks == kMostTicks) {
      return;  // in a tap of a quarter of an hour
    }
    if (ticks == kTicksBeforeStop) {
      kernel.stop();
      stopped = true;
    }
    require(ticks < most, "a program that is stopped ends");
    status = kernel.next(now);
    require(status != interp::TickStatus::starved, "a whole program does not starve");
    judge_tick(before, now, input.machine.limits);
    before = now;
  }
  require(now.v_mm_s == 0.0, "a program ends at rest");
  require(stopped || report.has_errors() == kernel.has_errors(), "check and run have one opinion");
  require(!kernel.fault(), "a run keeps what it promises");
  if (!stopped && !kernel.has_errors()) {
    require(now.position_mm == end.mm, "the last tick is the programmed end point");
    require(now.extra_rad_mm == end.extra_rad_mm, "the last tick is the end of further axes");
  }
}

void judge(std::span<const std::uint8_t> bytes) {
  if (const auto input = fuzz_input(bytes)) {
    if (const auto end = judge_reading(*input)) {
      judge_motion(*input, *end);
    }
  }
}

}  // namespace kerf::fuzz
