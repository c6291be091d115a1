#include "programs/kerf/run/trace_writer.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/program/temporary_folder.hpp"

namespace kerf::program {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(TraceWriter, WritesTheHeaderAndEveryRow) {
  const TemporaryFolder folder;
  const auto path = folder / "trace.csv";
  auto writer = TraceWriter::create(path.string(), {});
  ASSERT_TRUE(writer.has_value());
  constexpr int kRows = 20'000;  // several buffers
  for (int tick = 0; tick < kRows; ++tick) {
    writer->add({.tick = tick});
  }
  writer->close();
  EXPECT_FALSE(writer->error().has_value());
  const std::string text = text_of(path);
  EXPECT_EQ(text.substr(0, kTraceHeader.size()), kTraceHeader);
  std::istringstream lines(text.substr(kTraceHeader.size()));
  int tick = 0;
  for (std::string line; std::getline(lines, line); ++tick) {
    ASSERT_NEAR(std::stod(line), 0.001 * tick, 1e-9);
  }
  EXPECT_EQ(tick, kRows);
}

TEST(TraceWriter, SaysThatTheDiskIsFullAndInWhichLine) {
  auto writer = TraceWriter::create("/dev/full", {});
  ASSERT_TRUE(writer.has_value());
  for (int tick = 0; tick < 20'000; ++tick) {
    writer->add({.tick = tick, .line = 7});
  }
  ASSERT_TRUE(writer->error().has_value());
  EXPECT_EQ(*writer->error(), "/dev/full: No space left on device, in line 7");
  EXPECT_TRUE(writer->ended());
  writer->add({});
  writer->close();
}

TEST(TraceWriter, SaysSoAlsoWhenOnlyTheLastBufferMeetsTheFullDisk) {
  auto writer = TraceWriter::create("/dev/full", {});
  ASSERT_TRUE(writer.has_value());
  writer->add({});
  EXPECT_FALSE(writer->error().has_value());
  writer->close();
  EXPECT_TRUE(writer->error().has_value());
}

TEST(TraceWriter, EndsWithTheLastWholeRowWithinItsSize) {
  const TemporaryFolder folder;
  const auto path = folder / "trace.csv";
  for (const std::uint64_t most : {std::uint64_t{1000}, std::uint64_t{1'000'000}}) {
    auto writer = TraceWriter::create(path.string(), {.max_bytes = most});
    ASSERT_TRUE(writer.has_value());
    for (std::uint32_t tick = 0; tick < 20'000; ++tick) {
      writer->add({.tick = tick, .line = 1 + tick / 4});
    }
    writer->close();
    ASSERT_TRUE(writer->error().has_value());
    EXPECT_FALSE(std::filesystem::exists(path));
    const std::string text = text_of(path.string() + ".incomplete");
    EXPECT_LE(text.size(), most);
    EXPECT_GT(text.size() + 200, most);  // a row has less
    EXPECT_EQ(text.back(), '\n');
    const auto rows = static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n')) - 1;
    EXPECT_EQ(*writer->error(), path.string() + ": would be larger than " + std::to_string(most) +
                                    " bytes (--max-trace), in line " +
                                    std::to_string(1 + rows / 4));
  }
}

TEST(TraceWriter, RefusesAFolderThatIsNotThere) {
  const auto writer = TraceWriter::create("/nowhere/at/all.csv", {});
  ASSERT_FALSE(writer.has_value());
  EXPECT_EQ(writer.error(), "/nowhere/at/all.csv: No such file or directory");
}

}  // namespace
}  // namespace kerf::program
