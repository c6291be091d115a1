#include "programs/kerf/page/packed_numbers.hpp"

#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(PackedNumbers, AreDifferencesOfSevenBitsAByte) {
  PackedNumbers numbers;
  for (const std::int64_t number : {0, 1, -1, 64, 0}) {
    numbers.add(number);
  }
  // The differences 0, 1, -2, 65, -64 as zigzag: 0, 2, 3, 130, 127.
  EXPECT_EQ(numbers.bytes(), std::string("\x00\x02\x03\x82\x01\x7f", 6));
}

TEST(PackedNumbers, TakeTheLargestSteps) {
  PackedNumbers numbers;
  numbers.add(std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(numbers.bytes().size(), 10U);
}

}  // namespace
}  // namespace kerf::program
