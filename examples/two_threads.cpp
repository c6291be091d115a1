// One thread plans, the other ticks by the clock, as in a front end that drives a machine. The tick
// thread would have real-time priority; here it is an ordinary one, and prints every 100th
// setpoint.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <string_view>
#include <thread>

#include <kerf/kerf.hpp>

namespace {

constexpr std::string_view kProgram =
    "G21 G90 G17\n"
    "G1 X30 F3000\n"
    "G3 X30 Y20 J10\n"
    "G1 X0\n"
    "M30\n";

// Belongs to the planning thread: feed(), finish() and plan().
void plan(kerf::Kernel& kernel, const std::atomic<bool>& over) {
  std::string_view rest = kProgram;
  while (!over.load(std::memory_order_relaxed)) {
    if (kernel.plan()) {  // more text is needed
      kernel.feed(rest.substr(0, 16));
      rest.remove_prefix(rest.size() < 16 ? rest.size() : 16);
      if (rest.empty()) {
        kernel.finish();
      }
    } else {  // all within the horizon is planned
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
}

}  // namespace

int main() {
  const kerf::MachineSettings machine = kerf::default_machine();
  kerf::Kernel kernel(machine);
  std::atomic<bool> over = false;
  std::thread planner([&] { plan(kernel, over); });

  const std::chrono::duration<double> period(machine.limits.period_s);
  auto next_tick = std::chrono::steady_clock::now();
  kerf::Setpoint setpoint;
  kerf::TickStatus status = kerf::TickStatus::running;
  while (status == kerf::TickStatus::running || status == kerf::TickStatus::starved) {
    status = kernel.tick(setpoint);
    if (setpoint.tick % 100 == 0) {
      std::printf("%8.3f %8.3f %8.3f\n", setpoint.position_mm[0], setpoint.position_mm[1],
                  setpoint.position_mm[2]);
    }
    next_tick += std::chrono::duration_cast<std::chrono::steady_clock::duration>(period);
    std::this_thread::sleep_until(next_tick);
  }
  over.store(true, std::memory_order_relaxed);
  planner.join();
  if (const auto fault = kernel.fault()) {
    std::fprintf(stderr, "line %u: %s\n", fault->line, fault->what.c_str());
  }
  return status == kerf::TickStatus::finished ? 0 : 1;
}
