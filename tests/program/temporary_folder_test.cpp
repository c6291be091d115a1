#include "tests/program/temporary_folder.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(TemporaryFolder, IsOfNobodyElse) {
  const TemporaryFolder one;
  const TemporaryFolder other;
  EXPECT_NE(one.path(), other.path());
  std::ofstream(one / "drill.ngc") << "text";
  EXPECT_TRUE(std::filesystem::is_empty(other.path()));
}

TEST(TemporaryFolder, IsRemovedWithAllThatIsInIt) {
  std::filesystem::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    std::ofstream(folder / "drill.ngc") << "text";
    EXPECT_TRUE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace kerf::program
