// G-code text in, one setpoint per tick out: all that a CNC front end needs of Kerf.
#include <cstdio>
#include <string_view>

#include <kerf/kerf.hpp>

int main() {
  constexpr std::string_view kProgram =
      "G21 G90 G17\n"
      "G1 X30 F3000\n"
      "G3 X30 Y20 J10 (an arc that the line runs into)\n"
      "G1 X0\n"
      "M30\n";

  kerf::Kernel kernel(kerf::default_machine());
  kernel.feed(kProgram);
  kernel.finish();

  kerf::Setpoint setpoint;
  while (kernel.next(setpoint) == kerf::TickStatus::running) {
    const auto& [x_mm, y_mm, z_mm] = setpoint.position_mm;
    std::printf("%lld,%u,%.6f,%.6f,%.6f\n", static_cast<long long>(setpoint.tick), setpoint.line,
                x_mm, y_mm, z_mm);
  }
  for (const auto& diagnostic : kernel.diagnostics()) {
    std::fprintf(stderr, "%s\n", to_string(diagnostic, "program").c_str());
  }
  return kernel.has_errors() ? 1 : 0;
}
