// Cycles under random work offsets: where the program's origin lies changes no step of a cycle.
#include <random>

#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

class RandomCycle {
 public:
  explicit RandomCycle(std::uint32_t seed) : random_(seed) {
    inch_ = coin();
    const double size = inch_ ? 4.0 : 100.0;
    const std::string hole = word(" X", -size, size) + word(" Y", -size, size);
    const std::string clearance = word(" R", 0.1, 2.0);
    // Above the hole, or at R: there a rise to R and a way down to it have no length.
    const std::string above = coin() ? " Z" + clearance.substr(2) : word(" Z", 2.0, 5.0);
    const char* const kinds[] = {"G81", "G82 P0.5", "G83 Q0.4", "G73 Q0.4", "G85", "G89 P1"};
    offset_ = "G10 L2 P1" + word(" X", -700, 700) + word(" Y", -700, 700) + word(" Z", -90, 90) +
              (coin() ? word(" R", -180, 180) : "") + "\nG92" + word(" X", -9, 9) +
              word(" Y", -9, 9);
    cycle_ = "G0" + hole + "\nG0" + above + "\n" + (coin() ? "G98 " : "G99 ") +
             kinds[random_() % 6] + hole + word(" Z", -3.0, 0.0) + clearance + "\n" +
             (coin() ? hole.substr(1) + "\n" : "") + (coin() ? "G98\n" : "") +
             (coin() ? hole.substr(1) + "\n" : "") + word("X", -size, size) + "\n";
  }

  [[nodiscard]] std::string at_the_origin() const { return text("\n"); }
  [[nodiscard]] std::string shifted() const { return text(offset_); }

 private:
  bool coin() { return random_() % 2 == 0; }
  std::string word(const std::string& letter, double low, double high) {
    const double share = static_cast<double>(random_()) / 4294967296.0;
    std::ostringstream out;
    out << letter << std::round((low + (high - low) * share) * 1000.0) / 1000.0;
    return out.str();
  }
  [[nodiscard]] std::string text(const std::string& offset) const {
    return offset + (inch_ ? "\nG20" : "\nG21") + " F10 S500 M3\n" + cycle_ + "M2\n";
  }

  std::mt19937 random_;
  bool inch_ = false;
  std::string offset_;
  std::string cycle_;
};

struct Step {
  std::string what;  // but for where it leads
  double length_mm = 0.0;
};

// From the first block of the cycle on: the way there begins elsewhere.
std::vector<Step> cycle_steps_of(const std::string& text) {
  constexpr std::uint32_t kFirstLineOfCycle = 6;
  const Program program = read_program(text);
  EXPECT_FALSE(program.has_errors) << message_line(program.diagnostics.front(), text);
  std::vector<Step> steps;
  for (const Move& move : program.moves) {
    if (move.source.line < kFirstLineOfCycle) {
      continue;
    }
    if (const auto* line = std::get_if<LineMove>(&move.shape)) {
      const Point& begin = move.start_mm;
      const Point& end = line->end_mm;
      steps.push_back({move.rapid ? "rapid" : "feed",
                       std::hypot(end[0] - begin[0], end[1] - begin[1], end[2] - begin[2])});
    } else {
      steps.push_back({text_of(move), 0.0});
    }
  }
  return steps;
}

TEST(CyclesAtRandom, MakeTheSameStepsWhereverTheOriginLies) {
  for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
    const RandomCycle cycle(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + cycle.shifted());
    const std::vector<Step> wanted = cycle_steps_of(cycle.at_the_origin());
    const std::vector<Step> found = cycle_steps_of(cycle.shifted());
    ASSERT_EQ(found.size(), wanted.size());
    ASSERT_GE(found.size(), 3U);
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_EQ(found[i].what, wanted[i].what) << "step " << i;
      ASSERT_NEAR(found[i].length_mm, wanted[i].length_mm, 1e-6) << "step " << i;
    }
  }
}

}  // namespace
}  // namespace kerf::parser
