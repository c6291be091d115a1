#include "tests/kernel/singular_curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace kerf::test {

namespace {

using curves::ControlPoint;
using curves::NurbsData;

constexpr int kDecimals = 10;
constexpr double kSag = 5e-4;  // of the chord tolerance

double printed(double x) {
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(kDecimals);
  text << x;
  return std::strtod(text.str().c_str(), nullptr);
}

std::vector<double> uniform_knots(int degree, std::size_t points) {
  const auto p = static_cast<std::size_t>(degree);
  std::vector<double> knots(p + 1, 0.0);
  for (std::size_t i = 1; i < points - p; ++i) {
    knots.push_back(static_cast<double>(i));
  }
  knots.insert(knots.end(), p + 1, static_cast<double>(points - p));
  return knots;
}

NurbsData curve(int degree, std::vector<ControlPoint> points, std::vector<double> knots = {}) {
  if (knots.empty()) {
    knots = uniform_knots(degree, points.size());
  }
  return {.degree = degree, .points = std::move(points), .knots = std::move(knots)};
}

// A cubic whose arms cross by this much: 0 is a cusp, its square the radius of what is left of it.
NurbsData near_cusp(double crossing_mm) {
  return curve(3,
               {{{0, 0, 0}}, {{10.0 + crossing_mm, 10, 0}}, {{-crossing_mm, 10, 0}}, {{10, 0, 0}}});
}

NurbsData doubling_back(double rise_mm) {
  return curve(2, {{{0, 0, 0}}, {{10, rise_mm, 0}}, {{0, 2.0 * rise_mm, 0}}});
}

NurbsData weighted(int degree, double heavy) {
  const double light = 1.0 / heavy;
  return curve(degree, {{{0, 0, 0}, 1.0},
                        {{5, 8, 0}, heavy},
                        {{10, -3, 0}, light},
                        {{14, 6, 0}, heavy},
                        {{20, 2, 0}, light},
                        {{25, 9, 0}, 1.0},
                        {{30, 0, 0}, heavy},
                        {{33, 5, 0}, 1.0}});
}

NurbsData wave(int degree, int count) {
  std::vector<ControlPoint> points;
  for (int i = 0; i < count; ++i) {
    points.push_back({{3.0 * i, 6.0 * std::sin(1.7 * i), 2.0 * std::cos(2.3 * i)}});
  }
  return curve(degree, std::move(points));
}

NurbsData zigzag_curve(int degree) {
  std::vector<ControlPoint> points;
  for (int i = 0; i < 12; ++i) {
    points.push_back({{i % 2 == 1 ? 10.0 : 0.0, 1e-3 * i, 0.0}});
  }
  return curve(degree, std::move(points));
}

NurbsData thousand_points() {
  std::vector<ControlPoint> points;
  for (int i = 0; i < 1000; ++i) {
    const double radius = 8.0 * (1.0 + 0.2 * std::sin(0.31 * i));
    points.push_back({{radius * std::cos(0.02 * i), radius * std::sin(0.02 * i), 0.01 * i}});
  }
  return curve(3, std::move(points));
}

}  // namespace

const std::vector<SingularCurve>& singular_curves() {
  static const std::vector<SingularCurve> all{
      {"near_cusp",
       curve(3, {{{1, 0, 0}}, {{10, 5e-4, 0}}, {{2, 5e-4, 0}}, {{12, 0, 0}}, {{15, 3, 0}}})},
      {"two_near_cusps", curve(3, {{{0, 0, 0}},
                                   {{10, 1e-3, 0}},
                                   {{3, 1e-3, 0}},
                                   {{12, 0, 0}},
                                   {{20, 5, 0}},
                                   {{13, 5.001, 0}},
                                   {{22, 5.001, 0}},
                                   {{25, 8, 0}}})},
      {"crossing_1e_1", near_cusp(1e-1)},
      {"crossing_1e_3", near_cusp(1e-3)},
      {"crossing_1e_4", near_cusp(1e-4)},
      {"crossing_1e_5", near_cusp(1e-5)},
      {"crossing_1e_6", near_cusp(1e-6)},
      {"cusp", near_cusp(0.0)},
      {"doubling_back_1e_4", doubling_back(1e-4)},
      {"doubling_back_1e_6", doubling_back(1e-6)},
      {"doubling_back", doubling_back(0.0)},
      {"weights_of_six_decades", weighted(3, 1e3)},
      {"weights_of_six_decades_degree_5", weighted(5, 1e-3)},
      {"still_at_the_ends",
       curve(3, {{{0, 0, 0}}, {{0, 0, 0}}, {{5, 9, 0}}, {{10, 0, 0}}, {{15, 5, 0}}, {{15, 5, 0}}})},
      {"stiller_at_the_ends", curve(5, {{{0, 0, 0}},
                                        {{0, 0, 0}},
                                        {{0, 0, 0}},
                                        {{5, 9, 2}},
                                        {{10, 0, 0}},
                                        {{15, 5, 0}},
                                        {{15, 5, 0}},
                                        {{15, 5, 0}}})},
      {"millionfold_speed",
       curve(3, {{{0, 0, 0}}, {{1e-4, 0, 0}}, {{1e-2, 2e-3, 0}}, {{100, 50, 9}}})},
      {"corners_at_knots", curve(3,
                                 {{{0, 0, 0}},
                                  {{3, 5, 0}},
                                  {{6, 5, 0}},
                                  {{9, 0, 0}},
                                  {{12, 5, 0}},
                                  {{15, 5, 0}},
                                  {{18, 0, 0}}},
                                 {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2})},
      {"double_knots",
       curve(3, {{{0, 0, 0}}, {{3, 5, 0}}, {{6, 5, 0}}, {{12, -5, 0}}, {{15, -5, 0}}, {{18, 0, 0}}},
             {0, 0, 0, 0, 1, 1, 2, 2, 2, 2})},
      {"degree_1", wave(1, 12)},
      {"degree_2", wave(2, 24)},
      {"degree_9", wave(9, 24)},
      {"zigzag", zigzag_curve(3)},
      {"zigzag_degree_4", zigzag_curve(4)},
      {"thousand_points", thousand_points()}};
  return all;
}

NurbsData random_singular_curve(std::mt19937_64& random) {
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto log_uniform = [&](double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  };
  NurbsData data{.degree = 1 + static_cast<int>(uniform(0.0, 8.999)), .points = {}, .knots = {}};
  const int count = data.degree + 1 + static_cast<int>(uniform(0.0, 12.0));
  const double size = log_uniform(1e-3, 1e3);
  const double decades = uniform(0.0, 1.0) < 0.5 ? 0.0 : uniform(0.0, 3.0);
  const bool collinear = uniform(0.0, 1.0) < 0.3;
  const bool coincident = uniform(0.0, 1.0) < 0.3;
  const double near = log_uniform(1e-9, 1e-1);
  for (int i = 0; i < count; ++i) {
    ControlPoint point{.weight = std::pow(10.0, uniform(-decades, decades))};
    for (std::size_t k = 0; k < 3; ++k) {
      point.position_mm[k] = size * uniform(-1.0, 1.0) * (collinear && k > 0 ? near : 1.0);
    }
    if (i > 0 && coincident && uniform(0.0, 1.0) < 0.4) {
      const double share = uniform(0.0, 1.0) < 0.4 ? 0.0 : near;
      for (std::size_t k = 0; k < 3; ++k) {
        point.position_mm[k] = data.points.back().position_mm[k] + share * point.position_mm[k];
      }
    }
    data.points.push_back(point);
  }
  const bool repeated = uniform(0.0, 1.0) < 0.4;
  const bool uneven = uniform(0.0, 1.0) < 0.3;
  data.knots.assign(static_cast<std::size_t>(data.degree) + 1, 0.0);
  for (int i = 0, repeats = data.degree; i < count - data.degree - 1; ++i) {
    const bool again = repeated && repeats < data.degree && uniform(0.0, 1.0) < 0.5;
    repeats = again ? repeats + 1 : 1;
    const double step = uneven ? log_uniform(1e-3, 1e2) : uniform(0.5, 2.0);
    data.knots.push_back(data.knots.back() + (again ? 0.0 : step));
  }
  data.knots.insert(data.knots.end(), static_cast<std::size_t>(data.degree) + 1,
                    data.knots.back() + 1.0);
  return data;
}

std::string program_of(const NurbsData& data, double feedrate_mm_s) {
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(kDecimals);
  const auto axes = [&text](const curves::Position& at) {
    text << " X" << at[0] << " Y" << at[1] << " Z" << at[2];
  };
  text << "G21 G90 G17 G94\nG0";
  axes(data.points.front().position_mm);
  text << "\nG6.2 P" << data.degree + 1 << " F" << 60.0 * feedrate_mm_s;
  for (std::size_t i = 0; i < data.knots.size(); ++i) {
    text << " K" << data.knots[i];
    if (i < data.points.size()) {
      axes(data.points[i].position_mm);
      text << " R" << data.points[i].weight;
    }
    text << "\n";
  }
  text << "M2\n";
  return text.str();
}

NurbsData printed(const NurbsData& data) {
  NurbsData read = data;
  for (ControlPoint& point : read.points) {
    std::for_each(point.position_mm.begin(), point.position_mm.end(),
                  [](double& x) { x = printed(x); });
    point.weight = printed(point.weight);
  }
  std::for_each(read.knots.begin(), read.knots.end(), [](double& u) { u = printed(u); });
  return read;
}

RandomProgram curve_program(const SingularCase& made) {
  RandomProgram program{
      .text = program_of(made.data, made.feedrate_mm_s),
      .start_mm = made.data.points.front().position_mm,
      .end_mm = made.data.points.back().position_mm,
      .feedrate_mm_s = {},
      .path = {},
      .dense = dense_path(printed(made.data), kSag * made.limits.chord_tolerance_mm)};
  const auto lines = std::count(program.text.begin(), program.text.end(), '\n');
  program.feedrate_mm_s.assign(static_cast<std::size_t>(lines), made.feedrate_mm_s);
  return program;
}

SingularCase random_singular_case(std::uint64_t seed, double longest_s) {
  std::mt19937_64 random(seed);
  const auto log_uniform = [&random](double low, double high) {
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
  };
  SingularCase made{.data = random_singular_curve(random), .limits = {}};
  const auto& points = made.data.points;
  double polygon_mm = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    polygon_mm +=
        (curves::vec(points[i].position_mm) - curves::vec(points[i - 1].position_mm)).norm();
  }
  const double slowest = polygon_mm / longest_s;
  made.limits.chord_tolerance_mm = log_uniform(1e-5, 1e-2);
  const double spread = seed % 2 == 0 ? 1.0 : 100.0;
  const lookahead::MotionLimits middle{.velocity_mm_s = log_uniform(10.0, 1e3),
                                       .acceleration_mm_s2 = log_uniform(100.0, 2e4),
                                       .jerk_mm_s3 = log_uniform(1e3, 1e6)};
  for (lookahead::MotionLimits& axis : made.limits.axes) {
    const auto near = [&](double value) { return value * log_uniform(1.0 / spread, spread); };
    axis = {std::max(slowest, near(middle.velocity_mm_s)), near(middle.acceleration_mm_s2),
            near(middle.jerk_mm_s3)};
  }
  made.feedrate_mm_s = log_uniform(std::max(2e-5, slowest), 2e3);
  return made;
}

}  // namespace kerf::test
