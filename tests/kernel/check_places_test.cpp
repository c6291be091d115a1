// What the check says of where a program's path lies: on the machine, in work coordinates, and
// which part of it follows which work offset.
#include <string>

#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/machine.hpp>

namespace kerf::test {
namespace {

CheckReport check_at_places(const std::string& text, const MachineSettings& settings = {},
                            const KernelOptions& options = {}, const CheckBounds& bounds = {}) {
  bool given = false;
  return check_program(
      [&]() -> std::string_view {
        const bool first = !given;
        given = true;
        return first ? std::string_view(text) : std::string_view{};
      },
      settings, options, bounds);
}

MachineSettings with_offsets(const Position& g54_mm, const Position& g55_mm = {}) {
  MachineSettings settings;
  settings.program.work[0].origin_mm = g54_mm;
  settings.program.work[1].origin_mm = g55_mm;
  return settings;
}

void expect_box(const Extents& box, const Position& min_mm, const Position& max_mm) {
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(box.min_mm[k], min_mm[k], 1e-9) << "xyz"[k];
    EXPECT_NEAR(box.max_mm[k], max_mm[k], 1e-9) << "xyz"[k];
  }
}

void expect_range(const AxisRange& range, double min_mm, double max_mm) {
  EXPECT_NEAR(range.min_mm, min_mm, 1e-9);
  EXPECT_NEAR(range.max_mm, max_mm, 1e-9);
}

TEST(CheckPlaces, KeepCuttingApartFromAllMotion) {
  const CheckReport report =
      check_at_places("G21 G90\nG0 Z5\nG0 X30 Y20\nG1 Z-1 F600\nX50\nG0 Z5\nX0 Y0\nM2\n");
  expect_box(report.extents, {0, 0, -1}, {50, 20, 5});
  ASSERT_TRUE(report.cuts);
  expect_box(report.cutting_extents, {30, 20, -1}, {50, 20, 5});
  EXPECT_FALSE(check_at_places("G21 G90\nG0 X5\nM2\n").cuts);
}

TEST(CheckPlaces, AreInTheCoordinatesOfTheProgramToo) {
  // The tool's length and G92 count as in the program's own words.
  const CheckReport report =
      check_at_places("G21 G90\nG54\nG43.1 Z12\nG0 X10 Y20 Z3\nG1 X40 F600\nG92 X0\nG1 X5\nM2\n",
                      with_offsets({100, 200, -50}));
  ASSERT_FALSE(report.has_errors());
  EXPECT_TRUE(report.work_extents.is_known);
  EXPECT_EQ(report.work_extents.systems, std::vector<std::size_t>{0});
  expect_box(report.work_extents.cutting, {0, 20, 3}, {40, 20, 3});
  expect_box(report.cutting_extents, {110, 220, -35}, {145, 220, -35});
}

TEST(CheckPlaces, NameAllSystemsAndNoneThatIsTurned) {
  const CheckReport two =
      check_at_places("G21 G90\nG55\nG1 X10 F600\nG54\nX20\nM2\n", with_offsets({}, {300, 0, 0}));
  EXPECT_EQ(two.work_extents.systems, (std::vector<std::size_t>{1, 0}));
  EXPECT_TRUE(two.work_extents.is_known);
  EXPECT_FALSE(check_at_places("G21 G90\nG10 L2 P1 R30\nG1 X10 F600\nM2\n").work_extents.is_known);
}

TEST(CheckPlaces, ArePutDownToTheSystemThatACompensatedMoveWasReadIn) {
  const CheckReport report =
      check_at_places("G21 G90 G17\nT1 M6\nG41.1 D2\nG1 X10 F600\nX20\nG40\nX25\nG55\nG1 X0\nM2\n",
                      with_offsets({}, {1000, 0, 0}));
  ASSERT_FALSE(report.has_errors());
  // X25 of G54, and the way from it, which is X-975 of G55.
  EXPECT_NEAR(report.work_extents.all.min_mm[0], -975.0, 1e-9);
  EXPECT_NEAR(report.work_extents.all.max_mm[0], 25.0, 1e-9);
}

TEST(OffsetExtents, FollowTheOffsetThatIsInForce) {
  const CheckReport report =
      check_at_places("G21 G90\nG54\nG0 X10\nG1 X40 Y7 F600\nG55\nG1 X5\nM2\n",
                      with_offsets({100, 0, 0}, {300, 0, 0}));
  const OffsetExtents& offsets = report.offset_extents;
  expect_range(offsets.following[0][0], 110, 140);
  expect_range(offsets.following[1][0], 305, 305);
  expect_range(offsets.following[0][1], 7, 7);
  EXPECT_TRUE(offsets.following[1][1].is_empty()) << "no Y is programmed under G55";
  EXPECT_TRUE(offsets.following[0][2].is_empty());
  expect_range(offsets.fixed[0], 0, 0);
  expect_range(offsets.fixed[2], 0, 0);
}

TEST(OffsetExtents, LeaveTheMachinesOwnPlacesAlone) {
  MachineSettings settings = with_offsets({100, 0, -20});
  settings.program.first_home_mm = {-70, 0, 40};
  const CheckReport report =
      check_at_places("G21 G90\nG0 X10 Z1\nG53 G0 Z30\nG28 X10\nG1 X20 Z0 F600\nM2\n", settings);
  ASSERT_FALSE(report.has_errors());
  const OffsetExtents& offsets = report.offset_extents;
  expect_range(offsets.following[0][0], 110, 120);
  expect_range(offsets.following[0][2], -20, -19);
  expect_range(offsets.fixed[0], -70, 0);
  expect_range(offsets.fixed[2], 0, 30);
}

TEST(OffsetExtents, HaveTheBulgeOfArcs) {
  const CheckReport report = check_at_places(
      "G21 G90 G17\nG0 X10 Y0\nG2 X-10 Y0 I-10 J0 F600\nM2\n", with_offsets({0, 50, 0}));
  expect_range(report.offset_extents.following[0][1], 40, 50);
}

TEST(OffsetExtents, KnowWhatG92Undoes) {
  // G92 says where the tool is, wherever the offset lies.
  const CheckReport report =
      check_at_places("G21 G90\nG92 X5\nG1 X25 F600\nM2\n", with_offsets({100, 0, 0}));
  expect_range(report.offset_extents.fixed[0], 0, 20);
  EXPECT_TRUE(report.offset_extents.following[0][0].is_empty());
}

TEST(OffsetExtents, AreKnownWhereTheWayToTheFirstPlaceHasNoLength) {
  // The tool starts where the first two blocks lead, on a machine whose offsets are zero.
  const CheckReport report = check_at_places("G0 X0 Y0\nG0 Z0\nG1 F600 X70 Y-3\nG0 Z5\n");
  const OffsetExtents& offsets = report.offset_extents;
  expect_range(offsets.following[0][0], 0, 70);
  expect_range(offsets.following[0][1], -3, 0);
  expect_range(offsets.following[0][2], 0, 5);
  EXPECT_EQ(offsets.is_known, (std::array{true, true, true}));
}

// G54 at 10, 20, 0 and the tool where the first moves lead, but for Y, which a cut moves first.
TEST(OffsetExtents, HaveNoWayToWhereTheFirstMovesLead) {
  const OffsetExtents extents =
      check_at_places("G21 G90\nG0 X5\nZ3\nG1 Y7 F100\nX8\nM2\n", with_offsets({10.0, 20.0, 0.0}),
                      {.start_mm = {15.0, 0.0, 3.0}}, {.starts_at_first_places = true})
          .offset_extents;
  expect_range(extents.following[0][0], 15.0, 18.0);
  EXPECT_TRUE(extents.fixed[0].is_empty());
  expect_range(extents.following[0][1], 27.0, 27.0);
  expect_range(extents.fixed[1], 0.0, 0.0);
  expect_range(extents.following[0][2], 3.0, 3.0);
  EXPECT_TRUE(extents.fixed[2].is_empty());
}

TEST(OffsetExtents, HaveTheStartOfAnAxisThatNothingMoves) {
  const OffsetExtents extents =
      check_at_places("G21 G90\nG0 X5\nG1 X8 F100\nM2\n", with_offsets({}),
                      {.start_mm = {5.0, 0.0, 2.0}}, {.starts_at_first_places = true})
          .offset_extents;
  expect_range(extents.fixed[2], 2.0, 2.0);
}

// From machine zero a bow in Y, which is another one from another offset.
TEST(OffsetExtents, AreUnknownWhereACurveLeadsFromOneOffsetToAnother) {
  const OffsetExtents extents =
      check_at_places("G21 G90 G28 X0 Y0\nG5 I0 J60 P0 Q60 X50 Y0 F3000\nM2\n").offset_extents;
  EXPECT_EQ(extents.is_known, (std::array{false, false, true}));
}

TEST(OffsetExtents, AreKnownOfAnArcThatFollowsOneOffset) {
  const OffsetExtents extents =
      check_at_places("G21 G90 G17 G28 X0 Y0\nG1 X10 Y0 Z1 F3000\nG2 X30 I10 Z-5\nM2\n")
          .offset_extents;
  EXPECT_EQ(extents.is_known, (std::array{true, true, true}));
  expect_range(extents.following[0][1], 0, 10);
}

// As it is the arc stays between its ends; from another offset it bulges beyond them.
TEST(OffsetExtents, AreUnknownWhereAnArcBetweenTwoOffsetsMayBulge) {
  const OffsetExtents extents =
      check_at_places("G21 G90 G17 G28 X0 Y0\nG3 X200 Y-380 R275 F3000\nG1 Y50\nM2\n")
          .offset_extents;
  EXPECT_EQ(extents.is_known, (std::array{false, false, true}));
}

TEST(OffsetExtents, AreUnknownWhereTheProgramRunsAnotherWay) {
  for (const char* block : {"G4 P1", "G0 X5"}) {
    const CheckReport report =
        check_at_places("o1 if [#5221 GT 0]\n" + std::string(block) + "\no1 endif\nG1 F600 X70\n");
    EXPECT_EQ(report.offset_extents.is_known, (std::array{false, false, false})) << block;
  }
}

TEST(OffsetExtents, AreUnknownWhereAProgramAsksForItsOffset) {
  const CheckReport report =
      check_at_places("G21 G90\nG1 X[2 * #5221] F600\nM2\n", with_offsets({100, 0, 0}));
  ASSERT_FALSE(report.has_errors());
  EXPECT_FALSE(report.offset_extents.is_known[0]);
  EXPECT_TRUE(report.offset_extents.is_known[1]);
}

}  // namespace
}  // namespace kerf::test
