#include "programs/kerf/io/visible_text.hpp"

#include <string>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(VisibleText, LeavesWordsOfEveryLanguageAlone) {
  for (const char* const text :
       {"", "part 1.ngc", "Gr\u00f6\u00dfe.ngc", "\u5de5\u4ef6", "\\x1B", "\U0001F600"}) {
    EXPECT_EQ(visible(text), text);
  }
}

TEST(VisibleText, ShowsControlCharactersAsTheirBytes) {
  EXPECT_EQ(visible("\x1b[31mred\x07"), "\\x1B[31mred\\x07");
  EXPECT_EQ(visible("a\nb\tc\rd\x7f"), "a\\x0Ab\\x09c\\x0Dd\\x7F");
  EXPECT_EQ(visible(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(visible("\u009b2J"), "\\xC2\\x9B2J");
}

TEST(VisibleText, ShowsBytesThatAreNotUtf8) {
  EXPECT_EQ(visible("\x9b"
                    "2J"),
            "\\x9B2J");
  EXPECT_EQ(visible("\xff\xc3"), "\\xFF\\xC3");
  EXPECT_EQ(visible("\xed\xa0\x80"), "\\xED\\xA0\\x80");
}

TEST(VisibleText, ShowsWhatTurnsTheDirectionOfWriting) {
  EXPECT_EQ(visible("a\u202eb"), "a\\xE2\\x80\\xAEb");
}

}  // namespace
}  // namespace kerf::program
