// [SineSeries]: the contour errors of the paper's table, here of the simulated one.
#include <algorithm>
#include <string>

#include "bench/curve_run.hpp"
#include "bench/papers/comparison.hpp"
#include "bench/papers/papers.hpp"
#include "machine/simulated_table.hpp"

namespace kerf::bench {

using profiles::Profile;
using profiles::ProfileKind;

namespace {

struct ContourError {
  double max_um = 0.0;
  double mean_um = 0.0;
};

// Of the simulated table behind the ticks.
ContourError contour_error(const char* program, const MachineSettings& settings, ProfileKind kind,
                           Comparison& table) {
  constexpr double kMicrometre = 1e3;
  const lookahead::Block block =
      curve_block(program, settings.limits, settings.limits.path.velocity_mm_s);
  const PlannedRun run = plan_of({block}, settings.limits, Profile(kind));
  machine::SimulatedTable servo(settings.table);
  TickJudge judge({.limits = settings.limits});
  ContourError error;
  servo.enable({.mm = run.ticks.front().setpoint.position_mm});
  for (const TickOfRun& tick : run.ticks) {
    judge.add(tick.setpoint, tick.chord_error_mm);
    servo.write(tick.setpoint);
    const double um = kMicrometre * servo.read().contour_error_mm;
    error.max_um = std::max(error.max_um, um);
    error.mean_um += um / static_cast<double>(run.ticks.size());
  }
  const std::string name = program;
  table.require("the table follows " + name, servo.read().fault == machine::DriveFault::none);
  table.require(name + " keeps its limits", judge.excess().figure == TickExcess::Figure::none);
  return error;
}

}  // namespace

void add_contour_errors(const MachineSettings& settings, Comparison& table) {
  constexpr double kMaxBand_um = 3.0;
  constexpr double kMeanBand_um = 1.1;
  struct Row {
    const char* curve;
    ProfileKind kind;
    double max_um;
    double mean_um;
  };
  const std::string model =
      "a simulated table: its gains and friction are ours, the paper's are not in it";
  for (const Row& row : {Row{"butterfly", ProfileKind::sine, 19.9, 3.6},
                         Row{"butterfly", ProfileKind::sine_series, 20.9, 3.9},
                         Row{"trident7", ProfileKind::sine, 13.8, 2.2},
                         Row{"trident7", ProfileKind::sine_series, 15.7, 3.6}}) {
    const ContourError error =
        contour_error((std::string(row.curve) + ".ngc").c_str(), settings, row.kind, table);
    const std::string law = row.kind == ProfileKind::sine ? "single sine" : "sine series";
    const bool lost = row.curve == std::string("trident7");
    const auto add = [&](const char* what, double published, double here, double band) {
      table.add(
          {.name = row.curve + (", " + std::string(what)) + " contour error, " + law + " [um]",
           .published = published,
           .decimals = 1,
           .here = here,
           .band = band,
           .why = lost ? "the trident's points are lost; " + model : model});
    };
    add("largest", row.max_um, error.max_um, kMaxBand_um);
    add("mean", row.mean_um, error.mean_um, kMeanBand_um);
  }
}

}  // namespace kerf::bench
