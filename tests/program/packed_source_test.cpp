#include "programs/kerf/page/packed_source.hpp"

#include <string>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

PackedNumbers packed(std::initializer_list<std::int64_t> numbers) {
  PackedNumbers packed;
  for (const std::int64_t number : numbers) {
    packed.add(number);
  }
  return packed;
}

TEST(PackedSource, HasNumbersApartByLetterAndDecimals) {
  const PackedSource source = packed_source("G1 X0.050 Y-12.5\nX-0.125 Y7 X1.000\n");
  EXPECT_EQ(source.text, "G\1 X\4 Y\2\nX\4 Y\1 X\4\n");
  ASSERT_EQ(source.numbers.size(), 4U);
  EXPECT_EQ(source.numbers.at("X3").numbers.bytes(), packed({50, -125, 1000}).bytes());
  EXPECT_EQ(source.numbers.at("X3").count, 3U);
  EXPECT_EQ(source.numbers.at("Y1").numbers.bytes(), packed({-125}).bytes());
  EXPECT_EQ(source.numbers.at("Y0").numbers.bytes(), packed({7}).bytes());
}

TEST(PackedSource, KeepsWhatCouldNotBeWrittenAnew) {
  for (const char* const text : {"X01", "X.5", "X-0.00", "X+1", "X1234567890123456", "X0.12345678",
                                 "#1=5", "(5)", "X--1", "X"}) {
    EXPECT_EQ(packed_source(text).text, text);
  }
  EXPECT_EQ(packed_source("X5.").text, "X\1.");
  EXPECT_EQ(packed_source("X1.2.3").text, "X\2.3");
}

TEST(PackedSource, KeepsATextThatHasTheBytesOfNumbers) {
  const PackedSource source = packed_source("X1 (\3)\n");
  EXPECT_EQ(source.text, "X1 (\3)\n");
  EXPECT_TRUE(source.numbers.empty());
}

}  // namespace
}  // namespace kerf::program
