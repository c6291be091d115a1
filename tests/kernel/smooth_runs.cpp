#include "tests/kernel/smooth_runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "curves/nurbs_curve.hpp"
#include "kernel/pipeline.hpp"
#include "tests/kernel/random_machine.hpp"
#include "tests/kernel/random_program.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/singular_curves.hpp"

namespace kerf::test {

namespace {

using curves::Position;
using curves::vec;

constexpr double kFeedrate_mm_s = 400.0;
constexpr std::array kCurves{"butterfly", "circle", "mazatrol", "polygon", "rational4",
                             "scroll",    "star",   "trident7", "wm"};

struct Knots {
  enum class Style : unsigned char { uniform, chord, doubled };
  Style style = Style::uniform;
  int degree = 3;
};

// The path velocity, chord tolerance, acceleration and jerk of the axes of a fast, a mild and a
// router-like machine.
MachineSettings machine(std::size_t which) {
  struct Limits {
    double v, chord_mm, a, j;
  };
  constexpr std::array<Limits, 3> kLimits{{{.v = 400.0, .chord_mm = 1e-3, .a = 2500.0, .j = 1e5},
                                           {.v = 100.0, .chord_mm = 1e-3, .a = 1000.0, .j = 2e4},
                                           {.v = 800.0, .chord_mm = 5e-3, .a = 8000.0, .j = 4e5}}};
  const Limits& limits = kLimits[which];
  MachineSettings settings;
  settings.limits.path.velocity_mm_s = limits.v;
  settings.limits.chord_tolerance_mm = limits.chord_mm;
  settings.limits.axes.fill(
      {.velocity_mm_s = 1000.0, .acceleration_mm_s2 = limits.a, .jerk_mm_s3 = limits.j});
  return settings;
}

// A heading of eight random waves an axis; steps of 0.2 to 0.8 of step_mm.
std::vector<Position> smooth_points(std::size_t count, double step_mm, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto pick = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  struct Wave {
    double size, rate, phase;
  };
  std::array<std::array<Wave, 8>, 3> waves{};
  for (auto& axis : waves) {
    for (std::size_t k = 0; k < axis.size(); ++k) {
      const double number = static_cast<double>(k + 1);
      axis[k] = {pick(0.2, 1.0) / number, number * pick(0.8, 1.2), pick(0.0, 6.28)};
    }
  }
  std::vector<Position> points;
  Position at{};
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(at);
    const double place = static_cast<double>(i);
    Eigen::Vector3d heading = Eigen::Vector3d::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const Wave& wave : waves[axis]) {
        heading[static_cast<Eigen::Index>(axis)] +=
            wave.size * std::cos(0.02 * wave.rate * place + wave.phase);
      }
    }
    heading.z() *= 0.2;
    const double step =
        step_mm * (0.5 + 0.3 * std::sin(0.37 * place + static_cast<double>(seed % 100)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double moved =
          at[axis] + step * heading[static_cast<Eigen::Index>(axis)] / heading.norm();
      at[axis] = std::round(1e4 * moved) / 1e4;
    }
  }
  return points;
}

// Clamped; every seventh inner knot may be double.
std::vector<double> knots_of(const std::vector<Position>& points, const Knots& knots) {
  const auto degree = static_cast<std::size_t>(knots.degree);
  const std::size_t inner = points.size() - degree - 1;
  std::vector<double> values(degree + 1, 0.0);
  double chord = 0.0;
  for (std::size_t k = 0; k < inner; ++k) {
    const std::size_t from = k + degree / 2;
    chord += (vec(points[from + 1]) - vec(points[from])).norm();
    const bool repeats = knots.style == Knots::Style::doubled && degree > 2 && (k + 1) % 7 == 0;
    values.push_back(knots.style == Knots::Style::chord ? chord
                                                        : static_cast<double>(repeats ? k : k + 1));
  }
  const double end =
      knots.style == Knots::Style::chord ? chord + 1.0 : static_cast<double>(inner + 1);
  values.insert(values.end(), degree + 1, end);
  return values;
}

// Neighbours in the index differ in everything.
SmoothRun spline_run(std::size_t index, std::size_t points) {
  const std::size_t degree = 2 + index % 8;
  const std::size_t style = index / 8 % 3;
  const std::size_t which = index / 24 % 3;
  const bool blends = index / 72 % 2 == 1;
  const std::size_t seed = index / 144;
  curves::NurbsData data{.degree = static_cast<int>(degree), .points = {}, .knots = {}};
  const std::vector<Position> through = smooth_points(points, 1.0, seed);
  for (const Position& point : through) {
    data.points.push_back({.position_mm = point});
  }
  data.knots = knots_of(through, {static_cast<Knots::Style>(style), data.degree});
  return {.name = "degree " + std::to_string(degree) + ", knots " + std::to_string(style) +
                  ", machine " + std::to_string(which) + (blends ? ", G64" : ", G61") + ", seed " +
                  std::to_string(seed),
          .text = (blends ? "G64 P0.01\n" : "G61\n") + program_of(data, kFeedrate_mm_s),
          .settings = machine(which)};
}

SmoothRun shipped_run(std::size_t index) {
  const std::string name = kCurves[index % kCurves.size()];
  return {.name = name + ", limits " + std::to_string(index / kCurves.size()),
          .text = "G61\n" + shipped_program(name + ".ngc"),
          .settings = random_machine(index / kCurves.size(), Spread::common)};
}

SmoothRun lines_run(std::size_t index) {
  constexpr std::size_t kLines = 4000;
  const double step_mm = 0.05 * std::pow(20.0, static_cast<double>(index % 7) / 6.0);
  const double tolerance_mm = 1e-3 * std::pow(50.0, static_cast<double>(index / 7 % 5) / 4.0);
  std::array<char, 100> line{};
  std::snprintf(line.data(), line.size(), "G21 G90 G64 P%.4f Q%.4f F%.0f\n", tolerance_mm,
                tolerance_mm, 60.0 * kFeedrate_mm_s);
  std::string text = line.data();
  for (const Position& point : smooth_points(kLines, step_mm, index)) {
    std::snprintf(line.data(), line.size(), "G1 X%.4f Y%.4f Z%.4f\n", point[0], point[1], point[2]);
    text += line.data();
  }
  return {.name = "lines of " + std::to_string(step_mm) + " mm, P " + std::to_string(tolerance_mm),
          .text = text + "M2\n",
          .settings = machine(index % 3)};
}

SmoothRun random_run(std::size_t seed) {
  const MachineSettings settings =
      random_machine(seed, seed / 4 % 2 == 0 ? Spread::wide : Spread::common);
  const RandomProgram program =
      random_program(seed, {.arcs = seed % 4 != 0,
                            .nurbs = seed % 4 == 1,
                            .contour = seed % 7 == 0,
                            .blocks = seed % 7 == 0 ? 60 : 8,
                            .longest_mm = std::min(1e3, unhurried_mm(settings))});
  return {.name = "seed " + std::to_string(seed), .text = program.text, .settings = settings};
}

}  // namespace

std::string_view name_of(SmoothKind kind) {
  constexpr std::array<std::string_view, kSmoothKinds.size()> kNames{
      "splines of 2,500 points", "splines of 20,000 points", "shipped curves, random limits",
      "short lines in G64", "random programs"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::size_t count_of(SmoothKind kind) {
  constexpr std::array<std::size_t, kSmoothKinds.size()> kCounts{1152, 1152, 200 * kCurves.size(),
                                                                 200, 5000};
  return kCounts.at(static_cast<std::size_t>(kind));
}

SmoothRun smooth_run(SmoothKind kind, std::size_t index) {
  switch (kind) {
    case SmoothKind::spline:
      return spline_run(index, 2500);
    case SmoothKind::long_spline:
      return spline_run(index, 20'000);
    case SmoothKind::shipped:
      return shipped_run(index);
    case SmoothKind::lines:
      return lines_run(index);
    case SmoothKind::random:
      break;
  }
  return random_run(index);
}

SmoothPlan plan_of(const SmoothRun& run, ProfileKind profile) {
  KernelOptions options;
  options.profile.kind = profile;
  Pipeline pipeline({.settings = run.settings, .options = options});
  pipeline.feed(run.text);
  pipeline.finish();
  for (lookahead::Outbox outbox; pipeline.step(outbox) != Pipeline::Step::ended; outbox.clear()) {
  }
  SmoothPlan plan{
      .degradations = pipeline.totals().degradations,
      .time_s = static_cast<double>(pipeline.totals().ticks) * run.settings.limits.period_s,
      .complaint = pipeline.check().fault() ? pipeline.check().fault()->what : ""};
  if (pipeline.path().has_errors()) {
    plan.complaint += pipeline.path().diagnostics().front().message;
  }
  return plan;
}

}  // namespace kerf::test
