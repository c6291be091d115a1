#include "bench/parse_programs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "parser/program_reader.hpp"

namespace kerf::bench {

namespace {

template <class... Number>
void add(std::string& text, const char* format, Number... numbers) {
  std::array<char, 160> line{};
  const int length = std::snprintf(line.data(), line.size(), format, numbers...);
  text.append(line.data(), static_cast<std::size_t>(length));
}

// The rows of a finishing pass, one after another.
class Rows {
 public:
  void add_row(std::string& text) {
    const double y = std::fmod(row_ * 0.05, 200.0);
    add(text, "(row %d)\nG0 Z5.\nG0 X0. Y%.3f\nG1 Z%.4f F800.\nF2400.\n", row_, y,
        2 * std::sin(y * 0.1));
    double x = 0.0;
    for (int step = 0; step < 1000; ++step) {
      x += 0.15 + 0.05 * random();
      const double side = y + 0.002 * std::sin(x);
      const double z = 5 * std::sin(x * 0.05) * std::cos(y * 0.04) + 0.01 * random();
      add_step(text, step, {x, side, z});
    }
    add(text, "G0 Z25.\nG1 X%.4f F1200.\n", x + 0.5);
    ++row_;
  }

 private:
  double random() { return static_cast<double>(random_()) * 0x1p-32; }

  void add_step(std::string& text, int step, const std::array<double, 3>& point) {
    const auto [x, y, z] = point;
    if (step % 50 == 0) {
      add(text, "N%d G1 X%.4f Y%.4f Z%.4f F%d.\n", number_, x, y, z, 2000 + step);
      number_ = (number_ + 10) % 99990;
    } else if (step % 50 == 25) {
      add(text, "G1 X%.4f Y%.4f Z%.4f\n", x, y, z);
    } else if (step % 50 % 3 == 0) {
      add(text, "X%.4f Z%.4f\n", x, z);
    } else {
      add(text, "X%.4f Y%.4f Z%.4f\n", x, y, z);
    }
  }

  std::mt19937 random_{7};
  int row_ = 0;
  int number_ = 10;
};

constexpr std::string_view kHead =
    "(three-axis finishing pass, generated)\nG21 G90 G17 G94\nG0 X0. Y0. Z25.\nS12000 M3\nF2400.\n";

std::string rows(std::size_t bytes) {
  std::string text;
  text.reserve(bytes + bytes / 64 + 65536);
  Rows rows;
  while (text.size() < bytes) {
    rows.add_row(text);
  }
  return text;
}

std::uint64_t count_lines(std::string_view text) {
  return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
}

ParseProgram program_of(std::string text) {
  const std::uint64_t lines = count_lines(text);
  return {std::move(text), lines};
}

}  // namespace

ParseProgram finishing_pass(std::size_t bytes) {
  return program_of(std::string(kHead) + rows(bytes) + "M5\nM2\n");
}

ParseProgram finishing_pass_in_loop(std::size_t bytes) {
  return program_of(std::string(kHead) + "o100 repeat [1]\n" + rows(bytes) +
                    "o100 endrepeat\nM5\nM2\n");
}

ParseProgram short_loop(std::uint64_t lines) {
  const std::string body = rows(1);
  const std::uint64_t turns = lines / count_lines(body) + 1;
  std::string text(kHead);
  text += "o100 repeat [" + std::to_string(turns) + "]\n" + body + "o100 endrepeat\nM5\nM2\n";
  return {std::move(text), turns * (count_lines(body) + 1) + 8};
}

ParseProgram expression_loop(std::uint64_t lines) {
  const std::uint64_t turns = lines / 4 + 1;
  std::string text(kHead);
  text += "#1 = 0\no100 while [#1 LT " + std::to_string(turns) + "]\n#1 = [#1 + 1]\n";
  text += "G1 X[#1 * 0.0001] Y[20 * sin[#1 / 10]] Z-1.25\no100 endwhile\nM5\nM2\n";
  return {std::move(text), turns * 4 + 9};
}

ParseProgram circles(int count) {
  std::string text = "G21 G90 G17 F600\nG0 X0 Y0\n";
  for (int i = 0; i < count; ++i) {
    text += i % 2 == 0 ? "G2 X10.5 Y3.25 I5.25 J1.625\n" : "G3 X0. Y0. R-5.6\n";
  }
  return program_of(text + "M2\n");
}

ParseProgram curves(int count) {
  std::string text = "G21 G90 F600\nG0 X0 Y0 Z0\n";
  for (int i = 0; i < count; ++i) {
    text += "G6.2 P4 K0 X0 Y0 Z0 R1\nK0 X10.25 Y20.5 Z0.125 R0.7071\nK0 X20 Y-20 Z0.25\n";
    text += "K0 X30.5 Y20 Z0.375\nK1 X40 Y-20.125 Z0.5\nK2 X0 Y0 Z0\nK3\nK3\nK3\nK3\n";
  }
  return program_of(text + "M2\n");
}

std::int64_t read_moves(std::string_view text) {
  constexpr std::size_t kPiece = std::size_t{64} * 1024;
  parser::ProgramReader reader;
  parser::Move move;
  std::int64_t moves = 0;
  const auto fetch = [&] {
    while (reader.next(move)) {
      ++moves;
    }
  };
  for (std::size_t at = 0; at < text.size(); at += kPiece) {
    reader.feed(text.substr(at, kPiece));
    fetch();
  }
  reader.finish();
  fetch();
  return reader.has_errors() ? -1 : moves;
}

}  // namespace kerf::bench
