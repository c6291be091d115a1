#include "programs/kerf/io/output_file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/program/temporary_folder.hpp"

namespace kerf::program {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
 protected:
  static std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "trace.csv";
  fs::path incomplete_ = folder_ / "trace.csv.incomplete";
};

TEST_F(OutputFileTest, HasItsNameOnceItIsWhole) {
  auto file = OutputFile::create(path_.string());
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->write("1\n"), 0);
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_EQ(text_of(incomplete_), "1\n");
  EXPECT_EQ(file->finish(true), 0);
  EXPECT_EQ(text_of(path_), "1\n");
  EXPECT_FALSE(fs::exists(incomplete_));
  EXPECT_EQ(file->remains(), "");
}

TEST_F(OutputFileTest, IsMarkedInItsNameWhereSomeIsMissing) {
  auto file = OutputFile::create(path_.string());
  ASSERT_TRUE(file.has_value());
  file->write("1\n");
  EXPECT_EQ(file->finish(false), 0);
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_EQ(text_of(incomplete_), "1\n");
  EXPECT_EQ(file->remains(), "; what was written is in " + incomplete_.string());
}

// But while nothing is written the older one stays: another output may turn out to be impossible.
TEST_F(OutputFileTest, LeavesNothingOfAnEarlierRunUnderItsName) {
  std::ofstream(path_) << "old";
  auto file = OutputFile::create(path_.string());
  ASSERT_TRUE(file.has_value());
  EXPECT_TRUE(fs::exists(path_));
  file->write("new");
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(OutputFileTest, LeavesNothingWhereNothingWasWritten) {
  { auto file = OutputFile::create(path_.string()); }
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(OutputFileTest, LeavesALinkALink) {
  std::ofstream(folder_ / "target.csv") << "old";
  fs::create_symlink("target.csv", path_);
  auto file = OutputFile::create(path_.string());
  ASSERT_TRUE(file.has_value());
  file->write("new");
  file->finish(true);
  EXPECT_TRUE(fs::is_symlink(path_));
  EXPECT_EQ(text_of(folder_ / "target.csv"), "new");
}

TEST_F(OutputFileTest, WritesToADeviceAsItIs) {
  auto file = OutputFile::create("/dev/null");
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->write("1\n"), 0);
  EXPECT_EQ(file->finish(true), 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_FALSE(fs::exists("/dev/null.incomplete"));
}

TEST_F(OutputFileTest, SaysWhyItCannotBeWritten) {
  const auto missing = OutputFile::create("/nowhere/trace.csv");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error(), "/nowhere/trace.csv: No such file or directory");
  EXPECT_EQ(OutputFile::create("/dev/full")->write("1"), ENOSPC);
}

}  // namespace
}  // namespace kerf::program
