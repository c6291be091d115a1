// Plans of programs whose feedrates have a closed form: NAME.ngc and NAME.expect in golden/.
//
// A .expect file has one line `LINE FEEDRATE` for each end of a block in order, in mm/s, and lines
// that begin with # and say why the figures are right. Its first such line holds the limits of each
// axis and the profile: `#limits A J PROFILE`.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "parser/program_reader.hpp"
#include "tests/lookahead/blocks.hpp"
#include "tests/lookahead/motion.hpp"

namespace kerf::lookahead::test {
namespace {

struct BlockEndFeed {
  std::uint32_t line = 0;
  double feedrate_mm_s = 0.0;
};

struct Golden {
  PlannerSettings settings{};
  std::vector<BlockEndFeed> ends;
};

Golden read_golden(const std::filesystem::path& file) {
  Golden golden;
  std::ifstream stream(file);
  for (std::string text; std::getline(stream, text);) {
    std::istringstream words(text);
    if (text.rfind("#limits", 0) == 0) {
      std::string word;
      std::string profile;
      MotionLimits axis;
      words >> word >> axis.acceleration_mm_s2 >> axis.jerk_mm_s3 >> profile;
      golden.settings.limits = axis_limits(axis);
      golden.settings.profile = profiles::Profile{profiles::profile_kind(profile).value()};
    } else if (!text.empty() && text[0] != '#') {
      golden.ends.emplace_back();
      words >> golden.ends.back().line >> golden.ends.back().feedrate_mm_s;
    }
  }
  return golden;
}

std::vector<parser::Move> read_moves(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  parser::ProgramReader reader;
  reader.feed(text.str());
  reader.finish();
  std::vector<parser::Move> moves;
  for (parser::Move move; reader.next(move);) {
    if (!std::holds_alternative<parser::EventMove>(move.shape)) {
      moves.push_back(move);
    }
  }
  EXPECT_FALSE(reader.has_errors());
  return moves;
}

TEST(Golden, PlansHaveTheFeedratesOfTheirClosedForms) {
  int files = 0;
  const std::filesystem::path folder =
      std::filesystem::path(KERF_SOURCE_DIR) / "tests/lookahead/golden";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ngc") {
      continue;
    }
    SCOPED_TRACE(entry.path().filename());
    ++files;
    const Golden golden =
        read_golden(std::filesystem::path(entry.path()).replace_extension(".expect"));
    const Motion motion =
        plan(blocks_of(read_moves(entry.path()), golden.settings.limits), golden.settings);
    std::vector<BlockEndFeed> found;
    const auto& phases = motion.phases();
    for (std::size_t i = 0; i + 1 < phases.size(); ++i) {
      if (phases[i].curve != phases[i + 1].curve || phases[i + 1].ends_program) {
        found.push_back({phases[i].line, phases[i].law.ramp().v_end_mm_s});
      }
    }
    ASSERT_EQ(found.size(), golden.ends.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].line, golden.ends[i].line);
      EXPECT_NEAR(found[i].feedrate_mm_s, golden.ends[i].feedrate_mm_s, 1e-4);
    }
  }
  EXPECT_GE(files, 3);
}

}  // namespace
}  // namespace kerf::lookahead::test
