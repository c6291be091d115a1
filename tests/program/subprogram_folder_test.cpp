#include "programs/kerf/io/subprogram_folder.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/program/temporary_folder.hpp"

namespace kerf::program {
namespace {

using parser::Dialect;

class SubprogramFolder : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  [[nodiscard]] parser::SubprogramSource source(Dialect dialect = Dialect::rs274) const {
    return subprograms_beside((folder_ / "main.ngc").string(), dialect);
  }

  TemporaryFolder folder_;
};

TEST_F(SubprogramFolder, FindsAFileByItsName) {
  write("drill.ngc", "o<drill> sub\n");
  const auto found = source()("drill");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->text, "o<drill> sub\n");
  EXPECT_EQ(found->file, (folder_ / "drill.ngc").string());
  EXPECT_FALSE(source()("mill"));
}

TEST_F(SubprogramFolder, ReadsAFileOnce) {
  write("drill.ngc", "first");
  const auto subprograms = source();
  EXPECT_EQ(subprograms("drill")->text, "first");
  write("drill.ngc", "second");
  EXPECT_EQ(subprograms("drill")->text, "first");
  EXPECT_EQ(source()("drill")->text, "second");
}

TEST_F(SubprogramFolder, LeavesTheFolderForNoName) {
  write("drill.ngc", "text");
  EXPECT_FALSE(source()("../" + folder_.path().filename().string() + "/drill"));
  std::filesystem::create_directories(folder_ / "sub.ngc");
  EXPECT_FALSE(source()("sub")) << "a folder is no file";
}

TEST_F(SubprogramFolder, MayHaveOneWithoutExtensionInFanucAlone) {
  write("POCKET", "text");
  write("O7", "text");
  const std::string program = (folder_ / "main.nc").string();
  const auto may_be = [&](const char* name, bool is_fanuc) {
    const std::string path = (folder_ / name).string();
    return may_be_subprogram({.path = path, .program = program, .is_fanuc = is_fanuc});
  };
  EXPECT_TRUE(may_be("POCKET", true));
  EXPECT_FALSE(may_be("POCKET", false));
  EXPECT_TRUE(may_be("O7", false));
  EXPECT_FALSE(may_be("HOLE", true)) << "there is none";
}

TEST_F(SubprogramFolder, KnowsHowFanucProgramsAreNamed) {
  write("O0007.NC", "seven");
  write("12345.ngc", "long");
  EXPECT_EQ(source(Dialect::fanuc)("7")->text, "seven");
  EXPECT_EQ(source(Dialect::fanuc)("12345")->text, "long");
  EXPECT_FALSE(source(Dialect::rs274)("7"));
}

}  // namespace
}  // namespace kerf::program
