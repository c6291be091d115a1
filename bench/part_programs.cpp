#include "bench/part_programs.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace kerf::bench {

namespace {

constexpr std::uint32_t kLinesBefore = 1;

}  // namespace

PartWriter::PartWriter(const Point& start_mm, int decimals)
    : decimals_(decimals), units_per_mm_(std::pow(10.0, decimals)) {
  for (std::size_t k = 0; k < 3; ++k) {
    here_[k] = rounded(start_mm[k]);
  }
  program_.start_mm = here_;
}

double PartWriter::rounded(double value) const {
  return std::round(value * units_per_mm_) / units_per_mm_;
}

void PartWriter::write(char letter, double value) {
  std::array<char, 40> text{};
  const int length = std::snprintf(text.data(), text.size(), "%c%.*f", letter, decimals_, value);
  program_.body.append(text.data(), static_cast<std::size_t>(length));
}

void PartWriter::line_to(const Point& to_mm, bool rapid) {
  PathElement element{.from_mm = here_,
                      .to_mm = {rounded(to_mm[0]), rounded(to_mm[1]), rounded(to_mm[2])},
                      .line = static_cast<std::uint32_t>(program_.path.size()) + kLinesBefore + 1};
  program_.body += rapid ? "G0" : "G1";
  for (std::size_t k = 0; k < 3; ++k) {
    write("XYZ"[k], element.to_mm[k]);
  }
  program_.body += '\n';
  here_ = element.to_mm;
  program_.path.push_back(element);
}

void PartWriter::arc_to(const Arc& arc) {
  PathElement element{.from_mm = here_,
                      .to_mm = {rounded(arc.to_mm[0]), rounded(arc.to_mm[1]), rounded(arc.z_mm)},
                      .line = static_cast<std::uint32_t>(program_.path.size()) + kLinesBefore + 1};
  const double i = rounded(arc.centre_mm[0] - here_[0]);
  const double j = rounded(arc.centre_mm[1] - here_[1]);
  element.centre_mm = {here_[0] + i, here_[1] + j};
  element.radius_mm = std::hypot(i, j);
  element.begin_rad = std::atan2(-j, -i);
  const double end =
      std::atan2(element.to_mm[1] - element.centre_mm[1], element.to_mm[0] - element.centre_mm[0]);
  const double turned = arc.clockwise ? element.begin_rad - end : end - element.begin_rad;
  const double least = 1e-9;
  const double sweep = turned - kFullTurn_rad * std::floor((turned - least) / kFullTurn_rad);
  element.sweep_rad = arc.clockwise ? -sweep : sweep;
  program_.body += arc.clockwise ? "G2" : "G3";
  for (std::size_t k = 0; k < 3; ++k) {
    write("XYZ"[k], element.to_mm[k]);
  }
  write('I', i);
  write('J', j);
  program_.body += '\n';
  here_ = element.to_mm;
  program_.path.push_back(element);
}

PartProgram PartWriter::finish() {
  program_.body += "M2\n";
  return std::move(program_);
}

Point Flower::here() const {
  const double r = 20.0 + 5.0 * std::cos(5.0 * t_);
  return {45.0 + r * std::cos(t_), 50.0 + r * std::sin(t_), -1.0 + 0.5 * std::sin(3.0 * t_)};
}

// dt = step / |C'|, by the midpoint rule: the length of a step is within 1e-6 of what it is to be.
void Flower::advance() {
  const auto dt = [this](double t) {
    const double r = 20.0 + 5.0 * std::cos(5.0 * t);
    const double slope = -25.0 * std::sin(5.0 * t);
    return step_mm_ / std::hypot(r, slope, 1.5 * std::cos(3.0 * t));
  };
  t_ += dt(t_ + 0.5 * dt(t_));
}

PartProgram raster(int lines) {
  constexpr double kStep_mm = 0.2;
  constexpr int kSteps = 500;
  const auto point = [](double x, double y) {
    return Point{x, y, 5.0 * std::sin(x / 12.0) * std::cos(y / 9.0) + 0.3 * std::sin(x / 1.7)};
  };
  PartWriter writer(point(0.0, 0.0), 4);
  int written = 0;
  for (int row = 0; written < lines; ++row) {
    const double y = kStep_mm * row;
    const auto x_at = [row](int i) { return kStep_mm * (row % 2 == 0 ? i : kSteps - i); };
    if (row > 0) {
      writer.line_to(point(x_at(0), y));
      ++written;
    }
    for (int i = 1; i <= kSteps && written < lines; ++i, ++written) {
      writer.line_to(point(x_at(i), y));
    }
  }
  return writer.finish();
}

PartProgram flower(int decimals) {
  constexpr double kLength_mm = 20'000.0;
  constexpr double kStep_mm = 0.1;
  Flower curve(kStep_mm);
  PartWriter writer(curve.here(), decimals);
  double s = kStep_mm;
  while (s <= kLength_mm * (1.0 + 1e-12)) {
    curve.advance();
    writer.line_to(curve.here());
    s += kStep_mm;
  }
  return writer.finish();
}

PartProgram straight(double length_mm, int lines) {
  PartWriter writer({}, 4);
  for (int i = 1; i <= lines; ++i) {
    writer.line_to({length_mm * i / lines, 0.0, 0.0});
  }
  return writer.finish();
}

PartProgram square(double side_mm) {
  PartWriter writer({}, 4);
  writer.line_to({side_mm, 0.0, 0.0});
  writer.line_to({side_mm, side_mm, 0.0});
  writer.line_to({0.0, side_mm, 0.0});
  writer.line_to({0.0, 0.0, 0.0});
  return writer.finish();
}

// Steps of equal length: of the angle they are ds / sqrt(r^2 + (dr/da)^2).
PartProgram spiral(const SpiralShape& shape) {
  const double from = shape.from_radius_mm;
  const double to = shape.to_radius_mm;
  const double turn_length_mm = 0.1 * shape.lines;
  const double growth = 0.5 * (to * to - from * from) / turn_length_mm;  // of r by the angle
  const auto point = [&](double angle) {
    const double r = from + growth * angle;
    return Point{r * std::cos(angle), r * std::sin(angle), 0.0};
  };
  PartWriter writer(point(0.0), 4);
  double angle = 0.0;
  for (int i = 0; i < shape.lines; ++i) {
    const double middle = angle + 0.05 / std::hypot(from + growth * angle, growth);
    angle += 0.1 / std::hypot(from + growth * middle, growth);
    writer.line_to(point(angle));
  }
  return writer.finish();
}

}  // namespace kerf::bench
