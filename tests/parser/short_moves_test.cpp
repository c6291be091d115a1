// Moves that are too short to be one: left out, and nothing is lost by it.
#include "parser/moves/short_moves.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "parser/modal/machine_data.hpp"
#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

Move line(const Point& from_mm, const Point& to_mm) {
  Move move;
  move.shape = LineMove{to_mm};
  move.start_mm = from_mm;
  move.feedrate_mm_s = 10.0;
  return move;
}

double distance_mm(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TEST(ShortMoves, LeaveAMoveAloneThatIsLongEnough) {
  ShortMoves moves;
  Move move = line({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0 + 2e-10});
  EXPECT_TRUE(moves.take(move));
  EXPECT_EQ(move.start_mm, (Point{1.0, 2.0, 3.0}));
  EXPECT_EQ(*end_mm(move), (Point{1.0, 2.0, 3.0 + 2e-10}));
}

TEST(ShortMoves, LeaveOutAShorterOneAndStartTheNextWhereTheToolStayed) {
  ShortMoves moves;
  Move tiny = line({0, 0, 0}, {5e-17, 0, 0});
  EXPECT_FALSE(moves.take(tiny));
  Move next = line({5e-17, 0, 0}, {1, 0, 0});
  ASSERT_TRUE(moves.take(next));
  EXPECT_EQ(next.start_mm, (Point{0, 0, 0}));
  EXPECT_EQ(*end_mm(next), (Point{1, 0, 0}));
}

TEST(ShortMoves, LoseNothingInTenThousandOfThem) {
  ShortMoves moves;
  Point programmed{};
  Point tool{};
  int taken = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Point to{programmed[0] + 3e-11, programmed[1] - 1e-11, 0.0};
    Move move = line(programmed, to);
    programmed = to;
    if (moves.take(move)) {
      EXPECT_EQ(move.start_mm, tool);
      EXPECT_GE(way_mm(move), kShortestWay_mm);
      tool = *end_mm(move);
      ++taken;
    }
    ASSERT_LT(distance_mm(tool, programmed), kShortestWay_mm);
  }
  EXPECT_EQ(taken, 2500);  // four of 3.16e-11 mm are longer than 1e-10 mm, three are not
}

TEST(ShortMoves, KeepAFullCircleFullWhereTheToolStayedBeside) {
  ShortMoves moves;
  Move tiny = line({0, 0, 0}, {7e-11, 0, 0});
  EXPECT_FALSE(moves.take(tiny));
  Move circle;
  circle.start_mm = {7e-11, 0, 0};
  circle.shape = ArcMove{.centre_mm = {5.0, 0, 0}, .end_mm = circle.start_mm};
  ASSERT_TRUE(moves.take(circle));
  EXPECT_EQ(circle.start_mm, (Point{0, 0, 0}));
  EXPECT_EQ(*end_mm(circle), circle.start_mm);
  Move next = line({7e-11, 0, 0}, {0, 1, 0});
  ASSERT_TRUE(moves.take(next));
  EXPECT_EQ(next.start_mm, (Point{0, 0, 0}));
}

TEST(ShortMoves, TakeAHelixOfNoRadiusForItsRise) {
  ShortMoves moves;
  Move helix;
  helix.shape = ArcMove{.centre_mm = {1e-12, 0, 0}, .end_mm = {0, 0, 2.0}, .turns = 3};
  ASSERT_TRUE(moves.take(helix));
  ASSERT_TRUE(std::holds_alternative<LineMove>(helix.shape));
  EXPECT_EQ(*end_mm(helix), (Point{0, 0, 2.0}));
}

TEST(ShortMoves, LetAnExtraAxisMoveAloneInTheTimeThatTheFeedrateAsksFor) {
  ShortMoves moves;
  Move arc;  // 6e-11 mm long at 10 mm/s takes 6e-12 s
  arc.shape = ArcMove{.centre_mm = {1e-11, 0, 0}, .end_mm = {0, 0, 0}};
  arc.feedrate_mm_s = 10.0;
  arc.auxiliary.end_rad_mm[0] = 1.0;
  ASSERT_TRUE(moves.take(arc));
  EXPECT_EQ(*end_mm(arc), arc.start_mm);
  EXPECT_NEAR(arc.auxiliary.length_rad_mm() / arc.feedrate_mm_s, 2e-11 * 3.14159265358979 / 10.0,
              1e-17);
}

TEST(ShortMoves, AreNoMovesOfAProgramHoweverTheyCome) {
  for (const char* text :
       {"G1 F100 X[0.1+0.2-0.3]", "G1 F100 X[1/10**17]", "G1 F100 X[1/10**300/10**20]",
        "G0 X[1/10**11] Y[1/10**12]", "F100 G2 I[1/10**15]", "F100 G2 X[1/10**11] I[1/10**3]",
        "G10 L2 P1 X[1/10**11]\nG1 F100 X0", "X4\nG10 L2 P1 R[1/10**10]\nX4",
        "F100\no1 repeat [3]\nG91 G1 X0.1\no1 endrepeat\nX-0.3\nX0.5"}) {
    ReaderOptions options{.machine = default_program_data()};
    for (const Move& move :
         read_program(std::string("G1 F100\n") + text + "\nM2\n", options).moves) {
      EXPECT_TRUE(end_mm(move) == nullptr || way_mm(move) >= kShortestWay_mm) << text;
    }
  }
}

TEST(ShortMoves, OfAnExtraAxisBesideALongTurnDoNotSayHowLongItIs) {
  ReaderOptions options{.machine = default_program_data()};
  options.machine.extra_axes = letters('A', 'U');
  const Program program = read_program("G1 F360 A90 U[1/10**12]\nM2\n", options);
  ASSERT_FALSE(program.has_errors);
  ASSERT_EQ(program.moves.size(), 2U);
  EXPECT_NEAR(program.moves[0].auxiliary.length_rad_mm(), 1.5707963267949, 1e-12);
  EXPECT_NEAR(program.moves[0].feedrate_mm_s, 0.10471975511966, 1e-12);  // 6 degrees a second
}

TEST(ShortMoves, OfATurningAxisCountInDegrees) {
  ReaderOptions options{.machine = default_program_data()};
  options.machine.extra_axes = letters('A');
  EXPECT_EQ(read_program("G1 F360 A[3.384/10**9]\nM2\n", options).moves.size(), 2U);
  EXPECT_EQ(read_program("G1 F360 A[9/10**11]\nM2\n", options).moves.size(), 1U);
}

TEST(ShortMoves, DoNotKeepAnEndlessLoopAlive) {
  const Program program = read_program("G1 F100\no1 while [1]\nX[1/10**12]\nX0\no1 endwhile\nM2\n",
                                       {.machine = default_program_data()});
  EXPECT_TRUE(program.has_errors);
}

}  // namespace
}  // namespace kerf::parser
