#include "tests/smoothing/polylines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace kerf::test {

using curves::Position;
using parser::Move;

namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

Move move_from(const Position& start, const Tolerances& tolerances, double feedrate_mm_s) {
  Move move;
  move.start_mm = start;
  move.feedrate_mm_s = feedrate_mm_s;
  move.mode = parser::PathMode::blend;
  move.blend_tolerance_mm = tolerances.corner_mm;
  move.merge_tolerance_mm = tolerances.merge_mm;
  return move;
}

void number(std::vector<Move>& moves) {
  for (std::size_t i = 0; i < moves.size(); ++i) {
    moves[i].source.line = static_cast<std::uint32_t>(i + 1);
    moves[i].block = i + 1;
  }
}

class Maker {
 public:
  Maker(std::uint64_t seed, Size size) : random_(seed), modes_(~seed), size_(size) {}

  RandomMoves make() {
    RandomMoves program;
    program.tolerances = {.corner_mm = uniform(0.0, 1.0) < 0.1 ? 0.0 : decades(1e-3, 0.5),
                          .merge_mm = uniform(0.0, 1.0) < 0.1 ? 0.0 : decades(1e-3, 0.2)};
    decimals_ = whole(2, 7);
    const int pieces = whole(1, size_ == Size::full ? 5 : 3);
    for (int i = 0; i < pieces; ++i) {
      const std::size_t before = program.moves.size();
      add_piece(program);
      const parser::PathMode mode = any_mode();
      for (std::size_t k = before; k < program.moves.size(); ++k) {
        program.moves[k].mode = mode;
      }
    }
    number(program.moves);
    return program;
  }

 private:
  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  double decades(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

  int lines(int from, int to) { return size_ == Size::full ? whole(from, to) : whole(from, 20); }

  // G64 for three of four.
  parser::PathMode any_mode() {
    switch (std::uniform_int_distribution<int>(0, 7)(modes_)) {
      case 0:
        return parser::PathMode::exact_path;
      case 1:
        return parser::PathMode::exact_stop;
      default:
        return parser::PathMode::blend;
    }
  }

  void add_piece(RandomMoves& program) {
    switch (whole(0, 5)) {
      case 0:
        program.what += " wave";
        return add_wave(program);
      case 1:
        program.what += " straight";
        return add_straight(program);
      case 2:
        program.what += " zigzag";
        return add_zigzag(program);
      case 3:
        program.what += " walk";
        return add_walk(program);
      case 4:
        program.what += " arc";
        return add_arc(program);
      default:
        program.what += " loop";
        return add_loop(program);
    }
  }

  void line_to(const Position& point, RandomMoves& program) {
    const Position end = rounded(point, decimals_);
    if (end == at_) {
      return;
    }
    Move move = move_from(at_, program.tolerances, feedrate_mm_s_);
    move.shape = parser::LineMove{end};
    if (uniform(0.0, 1.0) < 0.01) {
      feedrate_mm_s_ = decades(1.0, 300.0);
    }
    program.moves.push_back(std::move(move));
    at_ = end;
  }

  void along(const std::function<Position(double)>& curve, int count, RandomMoves& program) {
    const Position from = at_;
    const Position zero = curve(0.0);
    for (int i = 1; i <= count; ++i) {
      const Position seen = curve(static_cast<double>(i) / count);
      line_to(
          {from[0] + seen[0] - zero[0], from[1] + seen[1] - zero[1], from[2] + seen[2] - zero[2]},
          program);
    }
  }

  void add_wave(RandomMoves& program) {
    const double length = decades(1.0, 100.0);
    const double height = length * decades(1e-3, 0.3);
    const double waves = uniform(0.3, 3.0) * kTurn_rad;
    const double phase = uniform(0.0, kTurn_rad);
    along(
        [=](double u) {
          return Position{length * u, height * std::sin(waves * u + phase),
                          0.3 * height * std::cos(1.7 * waves * u)};
        },
        lines(5, 900), program);
  }

  void add_loop(RandomMoves& program) {
    const double radius = decades(0.05, 30.0);
    const double turns = uniform(0.2, 2.0) * kTurn_rad * (whole(0, 1) == 0 ? 1.0 : -1.0);
    const double rise = uniform(-0.3, 0.3) * radius;
    along(
        [=](double u) {
          return Position{radius * std::cos(turns * u), radius * std::sin(turns * u), rise * u};
        },
        lines(6, 700), program);
  }

  void add_straight(RandomMoves& program) {
    const double length = decades(0.1, 200.0);
    const double direction = uniform(0.0, kTurn_rad);
    const double slope = uniform(-0.5, 0.5);
    along(
        [=](double u) {
          return Position{length * u * std::cos(direction), length * u * std::sin(direction),
                          length * u * slope};
        },
        lines(1, 600), program);
  }

  void add_zigzag(RandomMoves& program) {
    const double step = decades(0.01, 20.0);
    const double width = step * uniform(0.0, 3.0);
    const int count = lines(2, 40);
    const Position from = at_;
    for (int i = 1; i <= count; ++i) {
      line_to({from[0] + step * i, from[1] + (i % 2 == 0 ? 0.0 : width), from[2]}, program);
    }
  }

  // Any turn, any length: reversals and needles among them.
  void add_walk(RandomMoves& program) {
    const int count = lines(2, 40);
    const double size = decades(0.01, 20.0);
    for (int i = 0; i < count; ++i) {
      const double length = size * decades(0.05, 1.0);
      const double direction = uniform(0.0, kTurn_rad);
      line_to({at_[0] + length * std::cos(direction), at_[1] + length * std::sin(direction),
               at_[2] + 0.2 * length * uniform(-1.0, 1.0)},
              program);
    }
  }

  void add_arc(RandomMoves& program) {
    const double radius = decades(0.1, 50.0);
    const double towards = uniform(0.0, kTurn_rad);
    const ArcTo arc{.start_mm = at_,
                    .centre_mm = {at_[0] + radius * std::cos(towards),
                                  at_[1] + radius * std::sin(towards), at_[2]},
                    .angle_rad = uniform(0.1, 6.0) * (whole(0, 1) == 0 ? 1.0 : -1.0)};
    program.moves.push_back(arc_move(arc, program.tolerances, feedrate_mm_s_));
    at_ = std::get<parser::ArcMove>(program.moves.back().shape).end_mm;
  }

  std::mt19937_64 random_;
  std::mt19937_64 modes_;
  Size size_;
  Position at_{};
  double feedrate_mm_s_ = 100.0;
  int decimals_ = 3;
};

}  // namespace

Position rounded(const Position& point, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return {std::round(point[0] * scale) / scale, std::round(point[1] * scale) / scale,
          std::round(point[2] * scale) / scale};
}

std::vector<Move> lines_through(const std::vector<Position>& points, const Tolerances& tolerances,
                                double feedrate_mm_s) {
  std::vector<Move> moves;
  for (std::size_t i = 1; i < points.size(); ++i) {
    Move& move = moves.emplace_back(move_from(points[i - 1], tolerances, feedrate_mm_s));
    move.shape = parser::LineMove{points[i]};
  }
  number(moves);
  return moves;
}

Move arc_move(const ArcTo& arc, const Tolerances& tolerances, double feedrate_mm_s) {
  const double x = arc.start_mm[0] - arc.centre_mm[0];
  const double y = arc.start_mm[1] - arc.centre_mm[1];
  const double cosine = std::cos(arc.angle_rad);
  const double sine = std::sin(arc.angle_rad);
  Move move = move_from(arc.start_mm, tolerances, feedrate_mm_s);
  move.shape =
      parser::ArcMove{.centre_mm = arc.centre_mm,
                      .end_mm = {arc.centre_mm[0] + cosine * x - sine * y,
                                 arc.centre_mm[1] + sine * x + cosine * y, arc.start_mm[2]},
                      .clockwise = arc.angle_rad < 0.0};
  return move;
}

RandomMoves random_moves(std::uint64_t seed, Size size) {
  return Maker(seed, size).make();
}

}  // namespace kerf::test
