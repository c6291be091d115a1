#include "programs/program_file.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "programs/progress.hpp"
#include "programs/progress_bar.hpp"
#include "tests/program/temporary_folder.hpp"

namespace kerf::program {
namespace {

class ProgramFileTest : public testing::Test {
 protected:
  void write(const std::string& text, std::ios::openmode mode = std::ios::trunc) {
    std::ofstream(path_, std::ios::binary | std::ios::out | mode) << text;
  }
  static std::string rest_of(ProgramFile& file) {
    std::string text;
    for (auto piece = file.read(); piece && !piece->empty(); piece = file.read()) {
      text += *piece;
    }
    return text;
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "program.ngc";
};

TEST_F(ProgramFileTest, ReadsTheSameTwice) {
  std::string text;
  for (int i = 0; i < 20'000; ++i) {
    text += "G1 X" + std::to_string(i) + "\n";  // more than one piece
  }
  write(text);
  auto file = ProgramFile::open(path_.string());
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->size_bytes(), text.size());
  EXPECT_EQ(rest_of(*file), text);
  EXPECT_EQ(file->bytes_read(), text.size());
  file->rewind();
  EXPECT_EQ(rest_of(*file), text);
}

TEST_F(ProgramFileTest, GoesOnWhenTheFileIsDeleted) {
  write("G0 X1\n");
  auto file = ProgramFile::open(path_.string());
  ASSERT_TRUE(file.has_value());
  std::filesystem::remove(path_);
  EXPECT_EQ(rest_of(*file), "G0 X1\n");
}

TEST_F(ProgramFileTest, RefusesAFileThatIsWrittenToMeanwhile) {
  write("G0 X1\n");
  auto file = ProgramFile::open(path_.string());
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(rest_of(*file), "G0 X1\n");
  write("G0 X999\n", std::ios::app);
  file->rewind();
  const auto piece = file->read();
  ASSERT_FALSE(piece.has_value());
  EXPECT_EQ(piece.error(), path_.string() + ": changed while it was read");
}

TEST_F(ProgramFileTest, SaysWhyAFileCannotBeRead) {
  const auto missing = ProgramFile::open("/nowhere/part.ngc");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error(), "/nowhere/part.ngc: No such file or directory");
  const auto folder = ProgramFile::open(folder_.path().string());
  ASSERT_FALSE(folder.has_value());
  EXPECT_NE(folder.error().find("Is a directory"), std::string::npos);
}

TEST(ProgressLine, HasABarOfConstantWidth) {
  EXPECT_EQ(progress_line("running", 0.0), "running [" + std::string(40, ' ') + "]   0 %");
  EXPECT_EQ(progress_line("running", 0.5),
            "running [" + std::string(20, '#') + std::string(20, ' ') + "]  50 %");
  EXPECT_EQ(progress_line("running", 7.0), "running [" + std::string(40, '#') + "] 100 %");
}

TEST(Progress, IsTheShareOfThePathThatTheWholeTextWillGive) {
  Progress progress;
  EXPECT_EQ(progress.share(), 0.0);
  progress.set_read(0.5);
  progress.set_planned(100.0);
  progress.set_done(50.0);
  EXPECT_DOUBLE_EQ(progress.share(), 0.25);
  progress.set_read(1.0);
  progress.set_planned(200.0);
  progress.set_done(200.0);
  EXPECT_DOUBLE_EQ(progress.share(), 1.0);
}

}  // namespace
}  // namespace kerf::program
