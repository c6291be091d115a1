// The stage by itself, on random contours: the tool keeps its radius from them or they are refused.
#include <random>

#include <gtest/gtest.h>

#include "contour.hpp"
#include "diagnostics/diagnostic.hpp"
#include "diagnostics/errors/pages.hpp"

namespace kerf::parser {
namespace {

bool scratches(const Compensated& result) {
  return std::any_of(
      result.diagnostics.begin(), result.diagnostics.end(),
      [](const diagnostics::Diagnostic& one) { return one.page == &errors::kCompensationScratch; });
}

// One path: every move begins where the one before ended, and every arc has one radius.
void expect_whole(const Contour& contour, const Compensated& result) {
  Point at = contour.moves().front().start_mm;
  for (const Move& move : result.moves) {
    ASSERT_EQ(text_of(move.start_mm), text_of(at));
    if (const auto* arc = std::get_if<ArcMove>(&move.shape)) {
      const auto radius = [&](const Point& p) {
        return std::hypot(p[0] - arc->centre_mm[0], p[1] - arc->centre_mm[1]);
      };
      ASSERT_NEAR(radius(move.start_mm), radius(arc->end_mm), 1e-6);
      at = arc->end_mm;
    } else if (const auto* line = std::get_if<LineMove>(&move.shape)) {
      at = line->end_mm;
    }
  }
  ASSERT_EQ(text_of(at), text_of(std::get<LineMove>(contour.moves().back().shape).end_mm));
}

// A closed contour of lines and arcs about the origin that begins in the middle of a line.
Contour random_contour(std::mt19937& random) {
  const auto within = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  const int n = 3 + static_cast<int>(random() % 5);
  std::vector<Point> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * (i + within(-0.4, 0.4)) / n;
    const double radius = within(15, 60);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  if (random() % 2 == 0) {
    std::reverse(corners.begin(), corners.end());
  }
  const Point& first = corners[0];
  const Point& second = corners[1];
  const Point middle{(first[0] + second[0]) / 2, (first[1] + second[1]) / 2, 0};
  const auto beside = [&](double mm) {
    const double size = std::hypot(second[0] - first[0], second[1] - first[1]);
    return Point{middle[0] + mm * (second[0] - first[0]) / size,
                 middle[1] + mm * (second[1] - first[1]) / size, 0};
  };
  Contour contour(beside(-40));
  contour.line(middle[0], middle[1]).line(second[0], second[1]);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % corners.size()];
    const double bulge = within(-1.2, 1.2);  // of half the chord
    if (random() % 2 == 0 || std::fabs(bulge) < 0.05) {
      contour.line(b[0], b[1]);
      continue;
    }
    // The centre is on the chord's normal, off its middle by (1 - bulge^2) / (2 bulge) half chords.
    const double off = (1 - bulge * bulge) / (2 * bulge) / 2;
    contour.arc({b[0], b[1], (a[0] + b[0]) / 2 - off * (b[1] - a[1]),
                 (a[1] + b[1]) / 2 + off * (b[0] - a[0]), bulge < 0});
  }
  contour.line(middle[0], middle[1]);
  const Point out = beside(40);
  contour.line(out[0], out[1]);
  return contour;
}

TEST(CompensationStage, RandomContoursAreRefusedOrKeptAtTheRadius) {
  std::mt19937 random(20240717);
  int run = 0;
  int refused = 0;
  for (int i = 0; i < 600; ++i) {
    const Contour contour = random_contour(random);
    const CutterSide side = random() % 2 == 0 ? CutterSide::left : CutterSide::right;
    const double radius = 0.5 + 9.5 * static_cast<double>(random()) / 4294967296.0;
    const Compensated result = compensated(contour, {side, radius});
    if (result.refused() || scratches(result)) {
      ++refused;
      continue;
    }
    ++run;
    const double step = 0.25;
    expect_whole(contour, result);
    ASSERT_GE(clearance_mm(contour, result, step), radius - 1e-6) << "contour " << i << "\n"
                                                                  << text_of(result);
  }
  EXPECT_GT(run, 150);
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace kerf::parser
