#include "programs/kerf/start_place.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(StartPlace, IsAPositionOrTheFirstMove) {
  EXPECT_EQ(position_of("1,-2.5,30"), (Position{1.0, -2.5, 30.0}));
  EXPECT_EQ(std::get<Position>(*start_place_of("0,0,5")), (Position{0.0, 0.0, 5.0}));
  EXPECT_TRUE(std::holds_alternative<AtFirstMove>(*start_place_of("first-move")));
}

TEST(StartPlace, IsNothingElse) {
  for (const char* text : {"", "1", "1,2", "1,2,", "1,2,3,", "1,2,3,4", "1 ,2,3", "1,2,3 ", "x,y,z",
                           "nan,0,0", "0,inf,0", "1e9,0,0", "first", ",,"}) {
    EXPECT_FALSE(position_of(text)) << text;
    EXPECT_FALSE(start_place_of(text)) << text;
  }
}

}  // namespace
}  // namespace kerf::program
