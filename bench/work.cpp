#include "bench/work.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#endif

#include <kerf/kernel.hpp>

#include "bench/program_text.hpp"
#include "profiles/profile.hpp"
#include "tests/kernel/singular_curves.hpp"

namespace kerf::bench {

namespace {

[[gnu::noinline]] interp::TickStatus counted_tick(Kernel& kernel, interp::Setpoint& setpoint) {
  return kernel.tick(setpoint);
}

// A dump of what callgrind has counted since the one before.
void dump_counts() {
#ifdef CALLGRIND_DUMP_STATS
  CALLGRIND_DUMP_STATS;
#endif
}

MachineSettings machine_of_axes() {
  MachineSettings settings;
  settings.limits.path.velocity_mm_s = 100.0;
  settings.limits.chord_tolerance_mm = 5e-4;
  settings.limits.axes.fill(
      {.velocity_mm_s = lookahead::kUnbounded, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55e3});
  return settings;
}

}  // namespace

int work(const std::string& curve, Counted counted) {
  const auto& singular = test::singular_curves();
  const auto found =
      std::find_if(singular.begin(), singular.end(),
                   [&curve](const test::SingularCurve& one) { return one.name == curve; });
  const bool known = found != singular.end();
  KernelOptions options{.profile = profiles::Profile(profiles::ProfileKind::time_optimal)};
  if (known) {
    options.start_mm = found->data.points.front().position_mm;
  }
  Kernel kernel(machine_of_axes(), options);
  kernel.feed(known ? test::program_of(found->data, 100.0)
                    : source_file("programs/" + curve + ".ngc"));
  kernel.finish();
  std::int64_t ticks = 0;
  auto status = interp::TickStatus::running;
  for (interp::Setpoint setpoint; status == interp::TickStatus::running; ++ticks) {
    if (kernel.runs_low()) {
      kernel.plan();
      if (counted == Counted::windows) {
        dump_counts();
      }
    }
    status = counted_tick(kernel, setpoint);
    if (counted == Counted::ticks) {
      dump_counts();
    }
  }
  std::printf("%lld\n", static_cast<long long>(ticks));
  return status == interp::TickStatus::finished ? 0 : 1;
}

}  // namespace kerf::bench
