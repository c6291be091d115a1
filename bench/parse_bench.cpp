// Lines per second through the parser, every check on: a three-axis finishing pass of short lines
// with modal words, line numbers, comments and changes of feed, and programs of arcs and of NURBS.
// The text is in memory; what is measured is bytes in, moves out.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include <benchmark/benchmark.h>

#include "parser/program_reader.hpp"

namespace {

using kerf::parser::Move;
using kerf::parser::ProgramReader;

template <class... Number>
void add(std::string& text, const char* format, Number... numbers) {
  std::array<char, 160> line{};
  const int length = std::snprintf(line.data(), line.size(), format, numbers...);
  text.append(line.data(), static_cast<std::size_t>(length));
}

// Rows of 1000 steps of about 0.17 mm over a wavy surface, as a CAM system posts them.
std::string finishing_pass(int rows) {
  std::string text = "(three-axis finishing pass)\nG21 G90 G17 G94\nG0 X0. Y0. Z25.\nS12000 M3\n";
  int number = 10;
  for (int row = 0; row < rows; ++row) {
    const double y = row * 0.05;
    add(text, "(row %d)\nG0 Z5.\nG0 X0. Y%.3f\nG1 Z%.4f F800.\nF2400.\n", row, y,
        2 * std::sin(y * 0.1));
    double x = 0.0;
    for (int step = 0; step < 1000; ++step) {
      x += 0.15 + 0.05 * std::fabs(std::sin(step * 12.9898 + row * 78.233));
      const double z = 5 * std::sin(x * 0.05) * std::cos(y * 0.04);
      const double side = y + 0.002 * std::sin(x);
      if (step % 50 == 0) {
        add(text, "N%d G1 X%.4f Y%.4f Z%.4f F%d.\n", number, x, side, z, 2000 + step % 50);
        number = (number + 10) % 99990;
      } else if (step % 50 == 25) {
        add(text, "G1 X%.4f Y%.4f Z%.4f\n", x, side, z);
      } else if (step % 3 == 0) {
        add(text, "X%.4f Z%.4f\n", x, z);
      } else {
        add(text, "X%.4f Y%.4f Z%.4f\n", x, side, z);
      }
    }
  }
  return text + "M5\nM2\n";
}

std::string circles(int count) {
  std::string text = "G21 G90 G17 F600\nG0 X0 Y0\n";
  for (int i = 0; i < count; ++i) {
    text += i % 2 == 0 ? "G2 X10.5 Y3.25 I5.25 J1.625\n" : "G3 X0. Y0. R-5.6\n";
  }
  return text + "M2\n";
}

std::string curves(int count) {
  std::string text = "G21 G90 F600\nG0 X0 Y0 Z0\n";
  for (int i = 0; i < count; ++i) {
    text += "G6.2 P4 K0 X0 Y0 Z0 R1\nK0 X10.25 Y20.5 Z0.125 R0.7071\nK0 X20 Y-20 Z0.25\n";
    text += "K0 X30.5 Y20 Z0.375\nK1 X40 Y-20.125 Z0.5\nK2 X0 Y0 Z0\nK3\nK3\nK3\nK3\n";
  }
  return text + "M2\n";
}

void parse(benchmark::State& state, const std::string& text) {
  constexpr std::size_t kPiece = 64 * 1024;
  std::int64_t lines = 0;
  for (const char c : text) {
    lines += c == '\n' ? 1 : 0;
  }
  for (auto _ : state) {
    ProgramReader reader;
    Move move;
    for (std::size_t at = 0; at < text.size(); at += kPiece) {
      reader.feed(std::string_view(text).substr(at, kPiece));
      while (reader.next(move)) {
        benchmark::DoNotOptimize(move);
      }
    }
    reader.finish();
    while (reader.next(move)) {
      benchmark::DoNotOptimize(move);
    }
    if (reader.has_errors()) {
      state.SkipWithError("the program has errors");
    }
  }
  state.SetItemsProcessed(state.iterations() * lines);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void parse_finishing_pass(benchmark::State& state) {
  parse(state, finishing_pass(200));
}
void parse_circles(benchmark::State& state) {
  parse(state, circles(100'000));
}
void parse_nurbs(benchmark::State& state) {
  parse(state, curves(10'000));
}

BENCHMARK(parse_finishing_pass)->Unit(benchmark::kMillisecond);
BENCHMARK(parse_circles)->Unit(benchmark::kMillisecond);
BENCHMARK(parse_nurbs)->Unit(benchmark::kMillisecond);

}  // namespace
