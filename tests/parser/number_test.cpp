#include "parser/text/number.hpp"

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace kerf::parser {
namespace {

ScannedNumber scan(const std::string& text) {
  return scan_number(text.data(), text.data() + text.size());
}

TEST(Number, ReadsEveryPlainForm) {
  EXPECT_EQ(scan("12.5").value, 12.5);
  EXPECT_EQ(scan(".5").value, 0.5);
  EXPECT_EQ(scan("5.").value, 5.0);
  EXPECT_EQ(scan("+007.250").value, 7.25);
  EXPECT_EQ(scan("-0.1").value, -0.1);
}

TEST(Number, HasNoNegativeZero) {
  EXPECT_FALSE(std::signbit(scan("-0").value));
  EXPECT_FALSE(std::signbit(scan("-0.000").value));
  EXPECT_FALSE(std::signbit(scan("-0." + std::string(400, '0') + "1").value));
}

TEST(Number, StopsBehindItsLastDigit) {
  const std::string text = "12.5Y3";
  EXPECT_EQ(scan_number(text.data(), text.data() + text.size()).end, text.data() + 4);
}

TEST(Number, RefusesWhatIsNone) {
  for (const char* const text :
       {"", "-", "+", ".", "-.", "--1", "+-1", "nan", "inf", "1.2.3", "x"}) {
    EXPECT_EQ(scan(text).end, nullptr) << text;
  }
}

TEST(Number, LeavesAnExponentUnread) {
  const std::string text = "1e5";
  const ScannedNumber number = scan_number(text.data(), text.data() + text.size());
  EXPECT_EQ(number.value, 1.0);
  EXPECT_EQ(number.end, text.data() + 1);
}

TEST(Number, JoinsDigitsAcrossBlanksAndSaysSo) {
  const ScannedNumber number = scan("1 0. 5");
  EXPECT_EQ(number.value, 10.5);
  EXPECT_EQ(number.oddity, Oddity::blank_inside);
  EXPECT_EQ(scan("10.5 ").oddity, Oddity::none);
}

TEST(Number, SaysWhatIsBelowTheResolution) {
  for (const char* const fine : {"0.0000000009", "-.0000000001", "0.00000000000000000000000001"}) {
    EXPECT_EQ(scan(fine).oddity, Oddity::fine) << fine;
  }
  for (const char* const usual :
       {"0.000000001", "0.0000001", "0", "0.0000000", "-0.00000000000000000000", "1.00000001"}) {
    EXPECT_EQ(scan(usual).oddity, Oddity::none) << usual;
  }
  EXPECT_EQ(scan("." + std::string(5000, '0') + "1").oddity, Oddity::fine);
}

TEST(Number, OutOfRangeIsHugeAndTooSmallIsZero) {
  EXPECT_GE(scan(std::string(400, '9')).value, 1e300);
  EXPECT_LE(scan("-" + std::string(5000, '9')).value, -1e300);
  EXPECT_EQ(scan("." + std::string(5000, '0') + "1").value, 0.0);
}

// strtod in the "C" locale rounds correctly and shares no code with us.
TEST(Number, IsCorrectlyRounded) {
  constexpr unsigned kSeed = 20260521;
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 300'000; ++i) {
    std::string text = random() % 2 == 0 ? "-" : "";
    const auto digits = 1 + random() % 25;
    const auto point = random() % (digits + 1);
    for (std::size_t k = 0; k < digits; ++k) {
      text += k == point ? "." : "";
      text += static_cast<char>('0' + random() % 10);
    }
    ASSERT_EQ(scan(text).value, std::strtod(text.c_str(), nullptr)) << text << " seed " << kSeed;
  }
}

TEST(Number, IsCorrectlyRoundedHalfwayBetweenDoubles) {
  for (const char* const text : {"9007199254740993", "9007199254740992.5", "0.1234567890123456789",
                                 "1.00000000000000011102230246251565404236316680908203125",
                                 "1.00000000000000011102230246251565404236316680908203126",
                                 "1.00000000000000011102230246251565404236316680908203124"}) {
    EXPECT_EQ(scan(text).value, std::strtod(text, nullptr)) << text;
  }
}

}  // namespace
}  // namespace kerf::parser
