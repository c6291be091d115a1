#include "programs/kerf/run/reading_ahead.hpp"

#include <new>
#include <string>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "programs/kerf/run/feeder.hpp"

namespace kerf::program {
namespace {

Kernel kernel_that_reads_apart() {
  return Kernel(default_machine(), {.one_thread = true, .reads_apart = true});
}

// A line, and then what the test says.
class Text : public TextFeed {
 public:
  tl::expected<TextPiece, std::string> read() override {
    return ++reads_ == 1 ? TextPiece{TextPiece::State::text, "G1 X10 F6000\n"} : read_on();
  }
  [[nodiscard]] double share_read() const noexcept override { return 1.0; }

 private:
  virtual tl::expected<TextPiece, std::string> read_on() = 0;
  int reads_ = 0;
};

class BrokenText final : public Text {
  tl::expected<TextPiece, std::string> read_on() override {
    return tl::unexpected(std::string("the disk is gone"));
  }
};

class TextWithoutMemory final : public Text {
  tl::expected<TextPiece, std::string> read_on() override { throw std::bad_alloc(); }
};

class EndOfProgram final : public Text {
  tl::expected<TextPiece, std::string> read_on() override {
    return TextPiece{TextPiece::State::text, "M2\n"};
  }
};

TEST(ReadingAhead, FeedsThePlanToItsEnd) {
  Kernel kernel = kernel_that_reads_apart();
  EndOfProgram text;
  Progress progress;
  ReadingAhead reading(kernel, text, progress);
  EXPECT_FALSE(reading.plan());
  EXPECT_EQ(kernel.totals().path_length_mm, 10.0);
}

TEST(ReadingAhead, TellsTheFeederWhyTextCannotBeRead) {
  Kernel kernel = kernel_that_reads_apart();
  BrokenText text;
  Progress progress;
  ReadingAhead reading(kernel, text, progress);
  Feeder feeder(reading, reading, progress);
  feeder.pump();
  EXPECT_EQ(feeder.error(), "the disk is gone");
}

TEST(ReadingAhead, ThrowsWhatReadingThrewInTheThreadThatPlans) {
  Kernel kernel = kernel_that_reads_apart();
  TextWithoutMemory text;
  Progress progress;
  ReadingAhead reading(kernel, text, progress);
  EXPECT_THROW(reading.plan(), std::bad_alloc);
}

}  // namespace
}  // namespace kerf::program
