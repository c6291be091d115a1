#include "tests/kernel/degenerate_program.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace kerf::test {

namespace {

constexpr double kSmallTravel_mm = 150.0;
constexpr double kAny_mm_s = 1e12;  // no feedrate is judged: lines of a loop are many
constexpr double kPi = 3.14159265358979323846;

class DegenerateWriter {
 public:
  explicit DegenerateWriter(std::uint64_t seed) : random_(seed) {}

  RandomProgram write() {
    line("G21 G90 G17 G94 G40 G49 G80 G91.1 F" + number(uniform(100.0, 6000.0), 0));
    line(mode());
    const int blocks = 3 + below(6);
    for (int i = 0; i < blocks; ++i) {
      if (chance(0.55)) {
        tiny();
      } else {
        ordinary();
      }
      if (chance(0.1)) {
        line(mode());
      }
    }
    line("M2");
    program_.end_mm = here_;
    program_.end_a_deg = a_deg_;
    return std::move(program_);
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance(double share) { return uniform(0.0, 1.0) < share; }
  int below(int count) { return static_cast<int>(uniform(0.0, count - 1e-9)); }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }

  // Mostly where double and the plan have to do with each other, else over all that a double can.
  double tiny_mm() {
    const double decade = chance(0.75) ? uniform(-18.0, -6.0) : uniform(-320.0, -6.0);
    return sign() * std::pow(10.0, decade);
  }

  static std::string number(double x, int decimals) {
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, x);
    return text.data();
  }

  // An expression of this sign and size, and its value: three digits over one or two powers of ten.
  std::string expression(double& x) {
    if (x == 0.0) {
      return "[0]";
    }
    const int places = -static_cast<int>(std::floor(std::log10(std::abs(x))));
    const int first = std::min(places, 300);
    const int second = places - first;
    const double digits = std::floor(uniform(1.0, 9.99) * 100.0) / 100.0;
    std::string text = x < 0.0 ? "[-" : "[";
    text += number(digits, 2) + "/10**" + std::to_string(first);
    x = std::copysign(digits / std::pow(10.0, first), x);
    if (second > 0) {
      text += "/10**" + std::to_string(second);
      x /= std::pow(10.0, second);
    }
    return text + "]";
  }

  std::string mode() {
    constexpr std::array<const char*, 6> kModes{
        "G61", "G61.1", "G64", "G64 P0.01", "G64 P0.02 Q0.005", "G64 P0"};
    return kModes[static_cast<std::size_t>(below(static_cast<int>(kModes.size())))];
  }

  void line(const std::string& text) {
    program_.text += text + "\n";
    program_.feedrate_mm_s.push_back(kAny_mm_s);
  }

  static char letter(std::size_t axis) { return static_cast<char>('X' + axis); }

  void tiny() {
    switch (below(12)) {
      case 0:
        return tiny_absolute();
      case 1:
        return tiny_literal();
      case 2:
        return tiny_run();
      case 3:
        return tiny_by_offset();
      case 4:
        return tiny_by_rotation();
      case 5:
        return tiny_by_unit();
      case 6:
        return sum_of_increments();
      case 7:
        return tiny_arc();
      case 8:
        return tiny_nurbs();
      case 9:
        return tiny_extra();
      case 10:
        return tiny_cycle();
      default:
        return tiny_incremental();
    }
  }

  void tiny_absolute() {
    const auto axis = static_cast<std::size_t>(below(3));
    double step = tiny_mm();
    const std::string text = expression(step);
    line(std::string(chance(0.3) ? "G0 " : "G1 ") + letter(axis) + "[" + number(here_[axis], 9) +
         "+" + text + "]");
    here_[axis] = std::strtod(number(here_[axis], 9).c_str(), nullptr) + step;
  }

  void tiny_literal() {
    const auto axis = static_cast<std::size_t>(below(3));
    const std::string text =
        number(here_[axis] + sign() * std::pow(10.0, uniform(-10.0, -6.0)), 10);
    line(std::string("G1 ") + letter(axis) + text);
    here_[axis] = std::strtod(text.c_str(), nullptr);
    here_[axis] = std::abs(here_[axis]) < 1e-9 ? 0.0 : here_[axis];  // as a number is read
  }

  void tiny_incremental() {
    std::string text = chance(0.3) ? "G91 G0" : "G91 G1";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == 0 || chance(0.3)) {
        double step = tiny_mm();
        text += std::string(" ") + letter(axis) + expression(step);
        here_[axis] += step;
      }
    }
    line(text);
    line("G90");
  }

  // The same step up to 10,000 times, mostly few.
  void tiny_run() {
    const int count = static_cast<int>(std::pow(10.0, uniform(0.0, chance(0.05) ? 4.0 : 2.0)));
    double step = tiny_mm();
    const std::string text = expression(step);
    const auto axis = static_cast<std::size_t>(below(3));
    const bool zigzag = chance(0.3);
    const std::string loop = "o" + std::to_string(++loops_);
    line("G91 G1");
    line(loop + " repeat [" + std::to_string(count) + "]");
    line(letter(axis) + text);
    if (zigzag) {
      line(letter(axis) + ("[0-" + text + "]"));
    }
    line(loop + " endrepeat");
    line("G90");
    for (int i = 0; i < count; ++i) {
      here_[axis] += step;
      here_[axis] -= zigzag ? step : 0.0;
    }
  }

  // To the same coordinate under an offset that differs by little.
  void tiny_by_offset() {
    const auto axis = static_cast<std::size_t>(below(3));
    double step = tiny_mm();
    const std::string at = number(here_[axis], 6);
    line(std::string("G10 L2 P1 ") + letter(axis) + expression(step));
    line(std::string("G1 ") + letter(axis) + at);
    line(std::string("G10 L2 P1 ") + letter(axis) + "0");
    here_[axis] = std::strtod(at.c_str(), nullptr) + step;
  }

  void tiny_by_rotation() {
    const double angle = std::pow(10.0, uniform(-14.0, -9.0));
    const std::array<std::string, 2> at{number(here_[0], 6), number(here_[1], 6)};
    const double x = std::strtod(at[0].c_str(), nullptr);
    const double y = std::strtod(at[1].c_str(), nullptr);
    line("G10 L2 P1 R[" + number(angle * 1e14, 0) + "/10**14]");
    line("G1 X" + at[0] + " Y" + at[1]);
    line("G10 L2 P1 R0");
    const double rad = std::floor(angle * 1e14 + 0.5) / 1e14 * kPi / 180.0;
    here_[0] = x * std::cos(rad) - y * std::sin(rad);
    here_[1] = x * std::sin(rad) + y * std::cos(rad);
  }

  // Where it is, in inches.
  void tiny_by_unit() {
    const auto axis = static_cast<std::size_t>(below(3));
    const std::string at = number(here_[axis], 6);
    line(std::string("G20 G1 F100 ") + letter(axis) + "[" + at + "/25.4]");
    line("G21 F" + number(uniform(100.0, 6000.0), 0));
    here_[axis] = std::strtod(at.c_str(), nullptr) / 25.4 * 25.4;
  }

  // 0.1 three times and 0.3 back, and the like.
  void sum_of_increments() {
    const int count = 2 + below(30);
    const std::string part = number(0.1 * (1 + below(9)), 1);
    const double step = std::strtod(part.c_str(), nullptr);
    const std::string back = number(count * step, 1);
    const auto axis = static_cast<std::size_t>(below(3));
    const std::string loop = "o" + std::to_string(++loops_);
    line("G91 G1");
    line(loop + " repeat [" + std::to_string(count) + "]");
    line(letter(axis) + part);
    line(loop + " endrepeat");
    line(letter(axis) + ("-" + back));
    line("G90");
    for (int i = 0; i < count; ++i) {
      here_[axis] += step;
    }
    here_[axis] -= std::strtod(back.c_str(), nullptr);
  }

  void tiny_arc() {
    double radius = std::abs(tiny_mm());
    const std::string text = expression(radius);
    std::string block = std::string("G17 G91 ") + (chance(0.5) ? "G2" : "G3");
    const int form = below(3);
    if (form == 0) {  // a full circle
      block += " I" + text;
    } else if (form == 1) {  // half a circle
      block += " X[2*" + text + "] I" + text;
      here_[0] += 2.0 * radius;
    } else {  // a helix, tiny or with an ordinary rise
      double rise = chance(0.5) ? tiny_mm() : 0.0;
      std::string up = rise == 0.0 ? number(uniform(-3.0, 3.0), 3) : expression(rise);
      rise = rise == 0.0 ? std::strtod(up.c_str(), nullptr) : rise;
      block += " I" + text + " Z" + up + (chance(0.3) ? " P3" : "");
      here_[2] += rise;
    }
    line(block);
    line("G90 G1");
  }

  // Control points some or all of which are as good as one.
  void tiny_nurbs() {
    const int degree = 1 + below(3);
    const int points = degree + 1 + below(4);
    const double size = chance(0.5) ? 0.0 : uniform(0.1, 5.0);
    std::vector<int> knots(static_cast<std::size_t>(degree + 1), 0);
    for (int i = 1; i < points - degree; ++i) {
      knots.push_back(i);
    }
    knots.insert(knots.end(), static_cast<std::size_t>(degree + 1), points - degree);
    for (int i = 0; i < points; ++i) {
      std::string text = i == 0 ? "G6.2 P" + std::to_string(degree + 1) : "";
      text += " K" + std::to_string(knots[static_cast<std::size_t>(i)]);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        double step = i == 0 ? 0.0 : tiny_mm();
        std::string away = expression(step);
        if (i > 0 && size > 0.0 && chance(0.5)) {
          away = number(size * uniform(-1.0, 1.0), 4);
          step = std::strtod(away.c_str(), nullptr);
          away = "[" + away + "]";
        }
        const std::string at = number(here_[axis], 9);
        text += std::string(" ") + letter(axis) + "[" + at + "+" + away + "]";
        here_[axis] = i == 0 ? here_[axis] : std::strtod(at.c_str(), nullptr) + step;
      }
      line(text + " R1");
    }
    for (int i = 0; i <= degree; ++i) {
      line("K" + std::to_string(knots.back()));
    }
    line("G1");
  }

  // A alone by little, or by much beside a tiny way of X, or by little beside an ordinary one.
  void tiny_extra() {
    double step_deg = tiny_mm();
    double step_mm = tiny_mm();
    std::string turn = expression(step_deg);
    std::string way = expression(step_mm);
    const int form = below(3);
    if (form == 1) {
      turn = number(uniform(-90.0, 90.0), 2);
      step_deg = std::strtod(turn.c_str(), nullptr);
    } else if (form == 2) {
      way = number(uniform(-5.0, 5.0), 3);
      step_mm = std::strtod(way.c_str(), nullptr);
    }
    line("G91 G1 A" + turn + (form == 0 ? "" : " X" + way));
    line("G90");
    a_deg_ += step_deg;
    here_[0] += form == 0 ? 0.0 : step_mm;
  }

  // A hole as deep as nothing, where the tool is or beside it.
  void tiny_cycle() {
    double depth = std::abs(tiny_mm());
    const std::string z = number(here_[2], 6);
    const std::string text = expression(depth);
    constexpr std::array<const char*, 4> kCycles{"G81", "G82 P0.05", "G83 Q0.5", "G85"};
    line("G1 Z" + z);
    here_[2] = std::strtod(z.c_str(), nullptr);
    double beside = tiny_mm();
    const std::string x = number(here_[0], 6);
    line(std::string(kCycles[static_cast<std::size_t>(below(4))]) + " X[" + x + "+" +
         expression(beside) + "] Z[" + z + "-" + text + "] R" + z);
    line("G80 G1");
    here_[0] = std::strtod(x.c_str(), nullptr) + beside;
  }

  void ordinary() {
    switch (below(6)) {
      case 0:
        return arc();
      case 1:
        line("G4 P" + number(uniform(0.0, 0.02), 3));
        return;
      case 2:
        line(chance(0.5) ? "M8" : "M62 P1");
        return;
      case 3:
        return spline();
      default:
        return straight();
    }
  }

  void straight() {
    std::string text = chance(0.3) ? "G0" : "G1";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == 0 || chance(0.4)) {
        const double reach = std::pow(10.0, uniform(-5.0, 1.3));
        double to = here_[axis] + reach * sign();
        to = std::abs(to) > kSmallTravel_mm ? 0.0 : to;
        const std::string at = number(to, 6);
        text += std::string(" ") + letter(axis) + at;
        here_[axis] = std::strtod(at.c_str(), nullptr);
      }
    }
    line(text);
  }

  void arc() {
    const std::string radius = number(std::pow(10.0, uniform(-3.0, 1.0)), 5);
    const double r = std::strtod(radius.c_str(), nullptr);
    const bool full = chance(0.4);
    const std::string rise = chance(0.3) ? number(uniform(-2.0, 2.0), 3) : "0";
    line(std::string("G17 G91 ") + (chance(0.5) ? "G2" : "G3") +
         (full ? "" : " X[2*" + radius + "]") + " Z" + rise + " I" + radius);
    line("G90 G1");
    here_[0] += full ? 0.0 : 2.0 * r;
    here_[2] += std::strtod(rise.c_str(), nullptr);
  }

  void spline() {
    line("G5.1 X[" + number(here_[0], 9) + "+3] Y[" + number(here_[1], 9) + "+1] I1 J2");
    here_[0] = std::strtod(number(here_[0], 9).c_str(), nullptr) + 3.0;
    here_[1] = std::strtod(number(here_[1], 9).c_str(), nullptr) + 1.0;
    line("G1");
  }

  std::mt19937_64 random_;
  RandomProgram program_;
  Vec here_{};
  double a_deg_ = 0.0;
  int loops_ = 0;
};

}  // namespace

RandomProgram degenerate_program(std::uint64_t seed) {
  return DegenerateWriter(seed).write();
}

}  // namespace kerf::test
