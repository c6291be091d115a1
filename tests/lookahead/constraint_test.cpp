// What limits the feedrate: the cause is known by construction, and is one that can be acted on.
#include <algorithm>
#include <array>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr ProfileKind kOptimum = ProfileKind::time_optimal;
constexpr std::array kKinds{ProfileKind::s_curve, ProfileKind::sine,      ProfileKind::quintic,
                            ProfileKind::sigmoid, ProfileKind::trapezoid, kOptimum};

struct Shares {
  std::map<Constraint, double> of;
  double duration_s = 0.0;

  [[nodiscard]] double operator[](Constraint limit) const {
    const auto found = of.find(limit);
    return found == of.end() ? 0.0 : found->second;
  }
};

// At so many places of each phase.
Shares shares_of(const Motion& motion) {
  constexpr int kPlaces = 200;
  Shares shares;
  for (const interp::Phase& phase : motion.phases()) {
    if (phase.law.duration_s() == 0.0) {
      continue;
    }
    const double part = phase.law.duration_s() / kPlaces;
    for (int k = 0; k < kPlaces; ++k) {
      const bool steady = phase.law.at((k + 0.5) * part).j_mm_s3 == 0.0;
      shares.of[steady ? phase.active_constraint.steady : phase.active_constraint.limit] += part;
    }
    shares.duration_s += phase.law.duration_s();
  }
  for (auto& [limit, time_s] : shares.of) {
    time_s /= shares.duration_s;
  }
  return shares;
}

struct Program {
  std::vector<parser::Move> moves;
  PlanLimits limits{};
};

Shares shares_of(const Program& program, ProfileKind kind, std::size_t window = 1000) {
  return shares_of(
      plan(blocks_of(program.moves, program.limits),
           {.limits = program.limits, .profile = Profile(kind), .window_blocks = window}));
}

constexpr Constraint axis_a(std::size_t k) {
  return interp::of_axis(Constraint::x_acceleration, k);
}
constexpr Constraint axis_j(std::size_t k) {
  return interp::of_axis(Constraint::x_jerk, k);
}

TEST(Constraints, ALongLineIsLimitedByFAndAtItsEndsByTheAxis) {
  const Program program{{line_move({{0, 0, 0}, {600, 0, 0}}, 160.0)}, mill()};
  // Each ramp to 160 mm/s at 2000 mm/s2 and 5e4 mm/s3: 40 ms of jerk, 40 ms at constant
  // acceleration, 40 ms of jerk.
  for (const ProfileKind kind : {ProfileKind::s_curve, kOptimum}) {
    const Shares shares = shares_of(program, kind);
    const double place = 0.12 / 200;
    EXPECT_NEAR(shares[axis_j(0)] * shares.duration_s, 2 * 0.080, 4 * place);
    EXPECT_NEAR(shares[axis_a(0)] * shares.duration_s, 2 * 0.040, 4 * place);
    EXPECT_NEAR(shares[Constraint::programmed] * shares.duration_s,
                (600.0 - 2 * 0.5 * 160.0 * 0.12) / 160.0, 1e-9);
  }
}

TEST(Constraints, AddUpToTheWholeTime) {
  for (const ProfileKind kind : kKinds) {
    const Shares shares = shares_of({mixed_moves(), mill()}, kind);
    double sum = 0.0;
    for (const auto& [limit, share] : shares.of) {
      EXPECT_NE(limit, Constraint::rest);
      sum += share;
    }
    EXPECT_NEAR(sum, 1.0, 1e-9) << name_of(kind);
  }
}

TEST(Constraints, TheWeakAxisOfADiagonalIsNamed) {
  Program program{{line_move({{0, 0, 0}, {20, 20, 5}})}, mill()};
  program.limits.axes[1] = {
      .velocity_mm_s = 200.0, .acceleration_mm_s2 = 20.0, .jerk_mm_s3 = 500.0};
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::sine, kOptimum}) {
    const Shares shares = shares_of(program, kind);
    EXPECT_NEAR(shares[axis_a(1)] + shares[axis_j(1)], 1.0, 1e-9) << name_of(kind);
  }
}

TEST(Constraints, ASlowAxisHoldsARapidDown) {
  Program program{{line_move({{0, 0, 0}, {0, 0, 300}})}, mill()};
  program.moves.front().rapid = true;
  program.limits.axes[2].velocity_mm_s = 30.0;
  for (const ProfileKind kind : kKinds) {
    EXPECT_GT(shares_of(program, kind)[interp::of_axis(Constraint::x_velocity, 2)], 0.95);
  }
}

TEST(Constraints, ASmallCircleIsLimitedByTheAxesAcceleration) {
  const Program program{
      {arc_move({.ends = {{5, 0, 0}, {5, 0, 0}}, .centre = {0, 0, 0}}, 200.0)},
      axis_limits({.velocity_mm_s = 200.0, .acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 1e6})};
  for (const ProfileKind kind : {ProfileKind::s_curve, kOptimum}) {
    const Shares shares = shares_of(program, kind);
    EXPECT_GT(shares[axis_a(0)] + shares[axis_a(1)], 0.95) << name_of(kind);
  }
}

TEST(Constraints, ATightChordToleranceIsNamed) {
  Program program{{nurbs_move(nurbs_circle(5.0), 200.0)}, mill()};
  program.limits.chord_tolerance_mm = 1e-6;
  for (const ProfileKind kind : kKinds) {
    EXPECT_GT(shares_of(program, kind)[Constraint::chord_error], 0.9) << name_of(kind);
  }
}

TEST(Constraints, ManyLinesShorterThanTheirConstantVelocityAreLimitedByTheirJunctions) {
  const Program program{polyline(2000, 5.0, 50.0), mill()};
  for (const ProfileKind kind : kKinds) {
    EXPECT_GT(shares_of(program, kind)[Constraint::junction], 0.95) << name_of(kind);
  }
}

TEST(Constraints, AFeedFarBelowEverythingIsAllOfIt) {
  std::vector<parser::Move> moves = mixed_moves();
  for (parser::Move& move : moves) {
    move.feedrate_mm_s = 1.0;
  }
  for (const ProfileKind kind : kKinds) {
    EXPECT_GT(shares_of({moves, mill()}, kind)[Constraint::programmed], 0.99) << name_of(kind);
  }
}

TEST(Constraints, AWindowTooShortToBrakeInIsNamedAndALongOneIsNot) {
  const Program program{straight(400, 0.5, 150.0), mill()};
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::sine, kOptimum}) {
    EXPECT_GT(shares_of(program, kind, 8)[Constraint::window_end], 0.05) << name_of(kind);
    EXPECT_EQ(shares_of(program, kind, 1000)[Constraint::window_end], 0.0) << name_of(kind);
  }
}

// The law: more of a limit that is named saves time, more of one that is not saves none.
struct Knob {
  Constraint limit{};
  double* value = nullptr;
};

std::vector<Knob> knobs_of(PlanLimits& limits) {
  std::vector<Knob> knobs{{Constraint::path_velocity, &limits.path.velocity_mm_s},
                          {Constraint::path_acceleration, &limits.path.acceleration_mm_s2},
                          {Constraint::path_jerk, &limits.path.jerk_mm_s3},
                          {Constraint::chord_error, &limits.chord_tolerance_mm}};
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    MotionLimits& axis = limits.axes[k];
    knobs.push_back({interp::of_axis(Constraint::x_velocity, k), &axis.velocity_mm_s});
    knobs.push_back({axis_a(k), &axis.acceleration_mm_s2});
    knobs.push_back({axis_j(k), &axis.jerk_mm_s3});
  }
  return knobs;
}

struct LawCase {
  std::string name;
  Program program;
  ProfileKind kind;
  double more = 1.02;  // times a limit
};

void PrintTo(const LawCase& of, std::ostream* out) {
  *out << of.name;
}

class ConstraintLaw : public testing::TestWithParam<LawCase> {};

TEST_P(ConstraintLaw, MoreOfANamedLimitSavesTimeAndMoreOfAnotherDoesNot) {
  const auto& [name, program, kind, times] = GetParam();
  const Shares shares = shares_of(program, kind);
  PlanLimits more = program.limits;
  int named = 0;
  for (const auto& [limit, value] : knobs_of(more)) {
    const double before = *value;
    *value *= times;
    const double saved =
        1.0 - shares_of({program.moves, more}, kind).duration_s / shares.duration_s;
    *value = before;
    if (shares[limit] > 0.1) {
      // Of v, a and j alone all of the time goes with 1/v, 1/a^(1/2) and 1/j^(1/3); a tolerance
      // allows v by its root.
      EXPECT_GT(saved, (times - 1.0) * shares[limit] / 6.0) << static_cast<int>(limit);
      ++named;
    } else if (shares[limit] < 0.002) {
      EXPECT_LT(saved, (times - 1.0) * 0.01) << static_cast<int>(limit);
    }
  }
  EXPECT_GT(named, 0);
}

// No two limits alike.
PlanLimits uneven() {
  PlanLimits limits;
  limits.path = {.velocity_mm_s = 120.0, .acceleration_mm_s2 = 1900.0, .jerk_mm_s3 = 6e4};
  limits.axes[0] = {.velocity_mm_s = 60.0, .acceleration_mm_s2 = 900.0, .jerk_mm_s3 = 2.3e4};
  limits.axes[1] = {.velocity_mm_s = 110.0, .acceleration_mm_s2 = 1400.0, .jerk_mm_s3 = 1.9e4};
  limits.axes[2] = {.velocity_mm_s = 20.0, .acceleration_mm_s2 = 300.0, .jerk_mm_s3 = 9e3};
  limits.chord_tolerance_mm = 2e-4;
  return limits;
}

std::vector<LawCase> law_cases() {
  PlanLimits tight = uneven();
  tight.chord_tolerance_mm = 2e-6;
  PlanLimits path_only = uneven();
  path_only.axes = {};
  const std::vector<parser::Move> lines{
      line_move({{0, 0, 0}, {60, 5, 0}}), line_move({{60, 5, 0}, {58, 40, 2}}),
      line_move({{58, 40, 2}, {58, 40, 22}}), line_move({{58, 40, 22}, {0, 0, 22}})};
  const std::vector<parser::Move> butterfly{
      nurbs_move(curves::testing::shipped_curve("butterfly"))};
  const std::vector<parser::Move> trident{nurbs_move(curves::testing::shipped_curve("trident7"))};
  return {{"lines_s_curve", {lines, uneven()}, ProfileKind::s_curve},
          {"lines_sine", {lines, uneven()}, ProfileKind::sine},
          {"lines_quintic", {lines, uneven()}, ProfileKind::quintic},
          {"lines_optimum", {lines, uneven()}, kOptimum},
          // No optimum: a little more of the tolerance moves the places where it is cut.
          {"butterfly_s_curve", {butterfly, path_only}, ProfileKind::s_curve, 1.1},
          {"butterfly_optimum", {butterfly, uneven()}, kOptimum},
          {"trident_optimum", {trident, tight}, kOptimum}};
}

INSTANTIATE_TEST_SUITE_P(Programs, ConstraintLaw, testing::ValuesIn(law_cases()),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace kerf::lookahead::test
