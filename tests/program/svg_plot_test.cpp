#include "programs/kerf/plot/svg_plot.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "programs/kerf/plot/svg_canvas.hpp"

namespace kerf::program {
namespace {

constexpr curves::Extents kFlat{.min_mm = {0.0, 0.0, 0.0}, .max_mm = {100.0, 50.0, 0.0}};

PlotData data_of(int ticks, const curves::Extents& extents = kFlat) {
  PlotData data(extents);
  for (int tick = 0; tick < ticks; ++tick) {
    const double x = 0.01 * tick;
    data.add({.tick = tick,
              .motion = {.s_mm = x, .v_mm_s = 10.0 + std::sin(x), .a_mm_s2 = std::cos(x)},
              .position_mm = {x, 0.5 * x, 0.0}});
  }
  return data;
}

TEST(SvgPlot, IsADocumentWithAxesUnitsAndLimits) {
  const std::string svg =
      svg_plot(data_of(5000), {.title = "wing.ngc",
                               .subtitle = "s-curve",
                               .limits = {.velocity_mm_s = 12.0, .acceleration_mm_s2 = 2.0}});
  EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  for (const char* words : {"wing.ngc", "s-curve", "v, mm/s<", "a, mm/s\u00b2", "j, mm/s\u00b3",
                            "time, s", "limit 12<", "limit 2<", "feedrate, mm/s", "x, y in mm"}) {
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(SvgPlot, HasABandOfWhatHeldTheFeedDownWhereThatIsKept) {
  EXPECT_EQ(svg_plot(data_of(100), {}).find("limited by"), std::string::npos);
  PlotData data(kFlat);
  data.add_limits();
  for (int tick = 0; tick < 300; ++tick) {
    data.add({.tick = tick,
              .limit = tick < 100 ? Constraint::x_jerk : Constraint::programmed,
              .motion = {.v_mm_s = 10.0}});
  }
  const std::string svg = svg_plot(data, {});
  for (const char* words : {"limited by", ">axis x jerk<", ">programmed feedrate<"}) {
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(svg.find(">path jerk<"), std::string::npos) << "only what is there has a legend";
}

TEST(SvgPlot, MarksWhereThePathIsFarthestFromTheProgrammedOne) {
  EXPECT_EQ(svg_plot(data_of(100), {}).find("deviation"), std::string::npos);
  PlotCaption caption;
  caption.deviation = {.distance_mm = 0.0123, .at_mm = {0.5, 0.25, 0.0}, .line = 3};
  EXPECT_NE(svg_plot(data_of(100), caption).find(">deviation 0.012 mm<"), std::string::npos);
  caption.deviation->at_mm = {500.0, 0.0, 0.0};  // where the run never came
  EXPECT_EQ(svg_plot(data_of(100), caption).find("deviation"), std::string::npos);
}

TEST(SvgPlot, DrawsLongProgramsAsBandsAndShortOnesAsCurves) {
  EXPECT_EQ(svg_plot(data_of(5000), {}).find("fill-opacity"), std::string::npos);
  EXPECT_NE(svg_plot(data_of(100'000), {}).find("fill-opacity"), std::string::npos);
}

TEST(SvgPlot, FramesTheCutAndClipsTheWayToIt) {
  PlotData data({.min_mm = {300.0, 300.0, 0.0}, .max_mm = {400.0, 350.0, 0.0}});
  data.add({.tick = -2, .limit = interp::Constraint::rest});  // a dwell at zero cuts nothing
  data.add({.tick = -1, .limit = interp::Constraint::rest});
  data.add({.tick = 0, .rapid = true, .motion = {.v_mm_s = 10.0}});
  data.add(
      {.tick = 1, .rapid = true, .motion = {.v_mm_s = 10.0}, .position_mm = {300.0, 300.0, 0.0}});
  for (int tick = 2; tick <= 102; ++tick) {
    data.add({.tick = tick,
              .motion = {.v_mm_s = 10.0},
              .position_mm = {298.0 + tick, 300.0 + tick % 50, 0.0}});
  }
  const std::string svg = svg_plot(data, {});
  EXPECT_NE(svg.find("clip-path"), std::string::npos);
  EXPECT_NE(svg.find(">300<"), std::string::npos) << "numbers of the cut";
  EXPECT_NE(svg.find(">400<"), std::string::npos);
  EXPECT_EQ(svg.find(">100<"), std::string::npos) << "the way from machine zero";
}

TEST(SvgPlot, NamesTheLinesAtSharpPlaces) {
  PlotData data(kFlat);
  for (int tick = 0; tick < 1000; ++tick) {
    const double way = 0.1 * tick;
    data.add({.tick = tick,
              .line = way < 50.0 ? 7U : 8U,
              .motion = {.v_mm_s = 10.0},
              .position_mm = {std::min(way, 50.0), std::max(0.0, way - 50.0), 0.0}});
  }
  const std::string svg = svg_plot(data, {});
  EXPECT_TRUE(svg.find(">line 7<") != std::string::npos ||
              svg.find(">line 8<") != std::string::npos);
  EXPECT_EQ(svg_plot(data_of(5000), {}).find(">line "), std::string::npos) << "a straight line";
}

TEST(SvgPlot, HasAnotherUnitBesideMillimetresPerSecond) {
  const std::string svg =
      svg_plot(data_of(5000), {.title = {}, .subtitle = {}, .feed_unit = FeedUnit::mm_min});
  for (const char* words : {">v, mm/s; at the right mm/min<", ">mm/s<", ">mm/min<", ">600<"}) {
    EXPECT_NE(svg.find(words), std::string::npos) << words;  // 10 mm/s
  }
}

TEST(SvgPlot, StaysSmallHoweverLongTheRun) {
  EXPECT_LT(svg_plot(data_of(1'000'000), {}).size(), std::size_t{1'500'000});
}

TEST(SvgPlot, OfNothingIsADocumentToo) {
  for (const int ticks : {0, 1}) {
    const std::string svg = svg_plot(data_of(ticks, {}), {});
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    EXPECT_NE(svg.find("</svg>"), std::string::npos);
  }
}

TEST(SvgPlot, ShowsAPathThatIsNotFlatIsometrically) {
  const curves::Extents deep{.min_mm = {0, 0, -20}, .max_mm = {100, 50, 0}};
  EXPECT_EQ(view_of(deep), View::isometric);
  const std::string svg = svg_plot(data_of(100, deep), {});
  EXPECT_EQ(svg.find("x, y in mm"), std::string::npos);
  EXPECT_NE(svg.find(">z<"), std::string::npos);
}

TEST(SvgCanvas, EscapesWhatXmlWouldTakeForItself) {
  SvgCanvas canvas(10.0, 10.0);
  canvas.text({}, "<a&b>\x01 f\xc3\xbcr");
  EXPECT_NE(canvas.take().find(">&lt;a&amp;b&gt;\\x01 f\xc3\xbcr<"), std::string::npos);
}

TEST(SvgCanvas, ShowsBytesThatAreNotUtf8) {
  SvgCanvas canvas(10.0, 10.0);
  canvas.text({}, "fr\xe4sen");
  EXPECT_NE(canvas.take().find(">fr\\xE4sen<"), std::string::npos);
}

TEST(Projection, PutsTheBoxAroundEveryCorner) {
  const curves::Extents cube{.min_mm = {0, 0, 0}, .max_mm = {10, 10, 10}};
  const PaperBox box = box_of(View::isometric, cube);
  EXPECT_NEAR(box.width_mm(), 20.0 * std::sqrt(3.0) / 2.0, 1e-12);
  EXPECT_NEAR(box.height_mm(), 20.0, 1e-12);
  const PaperBox flat = box_of(View::top, cube);
  EXPECT_EQ(flat.width_mm(), 10.0);
}

}  // namespace
}  // namespace kerf::program
