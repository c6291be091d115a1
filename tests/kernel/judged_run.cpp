#include "tests/kernel/judged_run.hpp"

#include <algorithm>
#include <bit>

#include <kerf/kernel.hpp>

#include "tests/kernel/chord_checker.hpp"

namespace kerf::test {

namespace {

// What the scan of a curve's bound may miss, where only the kernel's account is there.
constexpr double kRelativeToLimit = 1e-6;

// FNV-1a by words (Fowler, Noll, Vo).
std::uint64_t stirred(std::uint64_t fingerprint, std::uint64_t word) {
  return (fingerprint ^ word) * 0x100000001b3U;
}

}  // namespace

JudgedRun judged_run(const RandomProgram& program, const MachineSettings& settings,
                     const Way& way) {
  Kernel kernel(settings, {.profile = profiles::Profile(way.kind),
                           .window_blocks = way.window_blocks,
                           .start_mm = program.start_mm});
  kernel.feed(program.text);
  kernel.finish();
  const double tolerance_mm = settings.limits.chord_tolerance_mm;
  TickChecker checker(settings.limits, way.kind != profiles::ProfileKind::trapezoid);
  ChordChecker chords(program.path, tolerance_mm);
  DenseChecker curve(program.dense, tolerance_mm);
  JudgedRun run;
  double kernel_says_mm = 0.0;
  std::size_t line_before = 1;
  auto status = interp::TickStatus::running;
  while (status == interp::TickStatus::running && run.complaint.empty()) {
    status = kernel.next(run.last);
    const std::size_t line = std::clamp<std::size_t>(run.last.line, 1, program.lines());
    checker.add({.setpoint = run.last, .feedrate_mm_s = program.fastest_mm_s(line_before, line)});
    line_before = line;
    run.fingerprint = stirred(run.fingerprint, run.last.line);
    for (const double coordinate : run.last.position_mm) {
      run.fingerprint = stirred(run.fingerprint, std::bit_cast<std::uint64_t>(coordinate));
    }
    kernel_says_mm = std::max(kernel_says_mm, kernel.chord_error_mm());
    if (!program.path.empty()) {
      chords.add(run.last, kernel.chord_error_mm());
    }
    if (!program.dense.empty()) {
      curve.add(run.last);
    }
    run.complaint = checker.complaint() + chords.complaint() + curve.complaint();
    if (run.complaint.empty() && checker.ticks() > way.max_ticks) {
      run.complaint = "does not end";
    }
  }
  if (kernel.has_errors()) {
    run.complaint = kernel.diagnostics().empty() ? "error" : kernel.diagnostics().back().message;
  } else if (kernel.fault()) {
    run.complaint += "internal error in line " + std::to_string(kernel.fault()->line) + ": " +
                     kernel.fault()->what;
  } else if (status == interp::TickStatus::starved) {
    run.complaint += "starved";
  } else if (program.path.empty() && kernel_says_mm > tolerance_mm * (1.0 + kRelativeToLimit)) {
    run.complaint += "chord error " + std::to_string(kernel_says_mm);
  }
  run.ticks = checker.ticks();
  run.worst = checker.worst();
  run.worst_chord =
      (program.path.empty() ? std::max(kernel_says_mm, curve.largest_mm()) : chords.largest_mm()) /
      tolerance_mm;
  run.degradations = kernel.totals().degradations.count;
  return run;
}

}  // namespace kerf::test
