#include "programs/kerf/io/program_file.hpp"

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "programs/kerf/io/progress.hpp"
#include "programs/kerf/io/progress_bar.hpp"
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

TEST_F(ProgramFileTest, RefusesWhatIsNoRegularFileWithoutWaitingForIt) {
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  const auto fifo = ProgramFile::open(path_.string());
  ASSERT_FALSE(fifo.has_value());
  EXPECT_EQ(fifo.error(), path_.string() + ": is a FIFO, not a regular file");
  const auto device = ProgramFile::open("/dev/zero");
  ASSERT_FALSE(device.has_value());
  EXPECT_EQ(device.error(), "/dev/zero: is a device, not a regular file");
}

TEST_F(ProgramFileTest, TakesAFifoForLiveTextButNoDevice) {
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_TRUE(ProgramFile::open_live(path_.string()).is_open());
  EXPECT_FALSE(ProgramFile::open_live("/dev/zero").is_open());
  EXPECT_FALSE(ProgramFile::open_live(folder_.path().string()).is_open());
  EXPECT_FALSE(ProgramFile::open_live("/nowhere/part.ngc").is_open());
}

// Standard input is that of the test while the object lives.
class StandardInput {
 public:
  explicit StandardInput(int other) : saved_(dup(STDIN_FILENO)) { dup2(other, STDIN_FILENO); }
  ~StandardInput() {
    dup2(saved_, STDIN_FILENO);
    close(saved_);
  }
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

 private:
  int saved_;
};

TEST_F(ProgramFileTest, CopiesNoMoreOfStandardInputThanItMay) {
  write("G0 X1\n");  // 6 bytes
  const Descriptor source(::open(path_.c_str(), O_RDONLY));
  const StandardInput input(source.number());
  EXPECT_TRUE(ProgramFile::open("-", 6).has_value());
  lseek(source.number(), 0, SEEK_SET);
  const auto refused = ProgramFile::open("-", 5);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error(),
            "<stdin>: more than 5 bytes: write them into a file and give its name");
}

TEST(ProgressLine, HasABarOfConstantWidth) {
  EXPECT_EQ(progress_line("running", {.share = 0.0}, 80),
            "running [" + std::string(40, ' ') + "]   0 %");
  EXPECT_EQ(progress_line("running", {.share = 0.5}, 200),
            "running [" + std::string(20, '#') + std::string(20, ' ') + "]  50 %");
  EXPECT_EQ(progress_line("running", {.share = 7.0}, 80),
            "running [" + std::string(40, '#') + "] 100 %");
}

TEST(ProgressLine, ShortensTheBarThenLeavesItOutThenIsCut) {
  const ProgressShown half{.share = 0.5, .left_s = 12.0};
  EXPECT_EQ(progress_line("running", half, 45), "running [#########         ]  50 %, 12 s left");
  EXPECT_EQ(progress_line("running", half, 35), "running [####    ]  50 %, 12 s left");
  EXPECT_EQ(progress_line("running", half, 34), "running  50 %, 12 s left");
  EXPECT_EQ(progress_line("running", half, 12), "running  50 ");
  EXPECT_EQ(progress_line("running", half, 0), "");
}

TEST(ProgressLine, SaysHowLongTheRestTakes) {
  const auto end_of = [](double left_s) {
    const std::string line = progress_line("", {.share = 0.5, .left_s = left_s}, 80);
    return line.substr(line.find('%'));
  };
  EXPECT_EQ(end_of(0.2), "%, 1 s left");
  EXPECT_EQ(end_of(59.5), "%, 1 min 00 s left");
  EXPECT_EQ(end_of(3599.0), "%, 59 min 59 s left");
  EXPECT_EQ(end_of(7384.0), "%, 2 h 03 min left");
}

TEST(ProgressBar, TakesTheRestForAsFastAsWhatIsDone) {
  EXPECT_DOUBLE_EQ(left_s_of({.elapsed_s = 30.0, .share = 0.25}).value(), 90.0);
  EXPECT_EQ(left_s_of({.elapsed_s = 30.0, .share = 1.0}), 0.0);
  EXPECT_FALSE(left_s_of({.elapsed_s = 1.0, .share = 0.25}).has_value()) << "too soon";
  EXPECT_FALSE(left_s_of({.elapsed_s = 30.0, .share = 0.001}).has_value()) << "too little";
  EXPECT_FALSE(left_s_of({.elapsed_s = 30.0, .share = 0.0}).has_value());
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

TEST(Progress, IsTheShareOfThePathThatACheckHasFound) {
  Progress progress(400.0);
  EXPECT_EQ(progress.share(), 0.0);
  progress.set_read(1.0);
  progress.set_planned(100.0);
  progress.set_done(50.0);
  EXPECT_DOUBLE_EQ(progress.share(), 0.125);
}

}  // namespace
}  // namespace kerf::program
