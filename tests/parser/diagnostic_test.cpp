#include "diagnostics/diagnostic.hpp"

#include <random>

#include <gtest/gtest.h>

#include "diagnostics/errors/pages.hpp"
#include "diagnostics/utf8.hpp"
#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

TEST(Diagnostic, HasTheFormThatEditorsUnderstand) {
  EXPECT_EQ(to_string(diagnostics::Diagnostic({12, 5}, errors::kUnknownGCode, "what"), "a/b.ngc"),
            "a/b.ngc:12:5: error: what [E0100]");
  EXPECT_EQ(to_string(diagnostics::Diagnostic({1, 1}, errors::kToolChangeWithoutTool, "what"), "x"),
            "x:1:1: warning: what [E0127]");
}

TEST(Diagnostic, ShowsTheBlockAndACaretUnderThePlace) {
  const Program program = read_program("G21\nG1 X10 F-100\nM2\n");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(to_text(program.diagnostics[0], "p.ngc"),
            "p.ngc:2:8: error: F must not be negative [E0120]\n"
            "    G1 X10 F-100\n"
            "           ^");
}

TEST(Diagnostic, ShowsNoBlockWhereItIsAboutTheWholeFile) {
  const Program program = read_program("G0 X1\n");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  EXPECT_EQ(to_text(program.diagnostics[0], "p"),
            "p:1:1: warning: the program has no M2, M30 or '%' at its end [E0009]");
}

TEST(Diagnostic, ShowsTheSameBlockHoweverTheTextIsCut) {
  for (const std::size_t piece : {1U, 3U, 1000U}) {
    const Program program = read_program("G0 X1\nG0 X1 Y-\nM2\n", {}, piece);
    ASSERT_EQ(program.diagnostics.size(), 1U);
    EXPECT_EQ(program.diagnostics[0].block.text, "G0 X1 Y-");
    EXPECT_EQ(program.diagnostics[0].block.caret, 7U);
  }
}

TEST(Excerpt, KeepsAShortLineAsItIs) {
  const diagnostics::Excerpt excerpt = diagnostics::excerpt_of("G1 X10 ?", 7);
  EXPECT_EQ(excerpt.text, "G1 X10 ?");
  EXPECT_EQ(excerpt.caret, 7U);
}

TEST(Excerpt, PutsTheCaretBehindTheLineForItsEnd) {
  EXPECT_EQ(diagnostics::excerpt_of("G1 X", 4).caret, 4U);
  EXPECT_EQ(diagnostics::excerpt_of("", 0).text, "");
  EXPECT_EQ(diagnostics::excerpt_of("G1", 100).caret, 2U) << "an offset past the line";
}

TEST(Excerpt, CutsALongLineRoundThePlace) {
  std::string line(1001, 'a');
  line[500] = '!';
  line.replace(501, 500, 500, 'b');
  const diagnostics::Excerpt excerpt = diagnostics::excerpt_of(line, 500);
  EXPECT_EQ(excerpt.text, "..." + std::string(60, 'a') + "!" + std::string(39, 'b') + "...");
  EXPECT_EQ(excerpt.text[excerpt.caret], '!');
}

TEST(Excerpt, NeverCutsACharacter) {
  std::string line;
  for (int i = 0; i < 200; ++i) {
    line += "\xC3\xA4";  // two bytes, one column
  }
  for (std::uint32_t at = 150; at < 154; ++at) {
    const diagnostics::Excerpt excerpt = diagnostics::excerpt_of(line, at);
    EXPECT_EQ(excerpt.text.find("\xEF\xBF\xBD"), std::string::npos) << at;
    EXPECT_EQ(excerpt.text.size() % 2, 0U) << at;
  }
}

// U+202E turns the direction of what follows it.
TEST(Excerpt, HidesWhatWouldChangeHowTheLineIsShown) {
  const diagnostics::Excerpt excerpt = diagnostics::excerpt_of(
      "G1 Q\xE2\x80\xAE"
      "5 X1 Y1",
      4);
  EXPECT_EQ(excerpt.text,
            "G1 Q\xEF\xBF\xBD"
            "5 X1 Y1");
  EXPECT_EQ(excerpt.caret, 4U);
}

TEST(Excerpt, CountsCharactersAndNotBytes) {
  EXPECT_EQ(diagnostics::excerpt_of("(\xC3\xA4\xC3\xB6) X", 7).caret, 5U);
  EXPECT_EQ(diagnostics::excerpt_of("(\xE4\xB8\xAD) X", 6).caret, 5U)
      << "a character two columns wide";
  EXPECT_EQ(diagnostics::excerpt_of("(e\xCC\x81) X", 6).caret, 4U) << "a combining accent";
}

TEST(Excerpt, ShowsTabsAsOneBlankAndWhatIsNoCharacterAsAMark) {
  const diagnostics::Excerpt excerpt = diagnostics::excerpt_of("\tG1\tX\xFF\x01Y Z1", 7);
  EXPECT_EQ(excerpt.text, " G1 X\xEF\xBF\xBD\xEF\xBF\xBDY Z1");
  EXPECT_EQ(excerpt.caret, 7U);
}

TEST(Excerpt, OfBinaryDataHasNoText) {
  using std::string_view_literals::operator""sv;
  EXPECT_EQ(diagnostics::excerpt_of("G\0001\0 \0X\0"sv, 3).text, "");
}

TEST(Excerpt, OfAnyBytesIsShortValidTextWithTheCaretInsideIt) {
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  constexpr std::string_view kBytes =
      "G1 X\t\xC3\xA4\xE2\x88\x92\xF0\x9F\x99\x82\xFF\x80\xCC\x81\x01";
  std::uniform_int_distribution<std::size_t> pick(0, kBytes.size() - 1);
  std::uniform_int_distribution<std::size_t> length(0, 300);
  for (int round = 0; round < 500; ++round) {
    std::string line(length(random), ' ');
    std::generate(line.begin(), line.end(), [&] { return kBytes[pick(random)]; });
    for (std::uint32_t at = 0; at <= line.size() + 1; at += 7) {
      const diagnostics::Excerpt excerpt = diagnostics::excerpt_of(line, at);
      for (std::size_t i = 0; i < excerpt.text.size();) {
        const diagnostics::Utf8 character =
            diagnostics::utf8_at(std::string_view(excerpt.text).substr(i));
        ASSERT_GE(character.code, 0x20U) << line;
        i += character.length;
      }
      EXPECT_LE(excerpt.text.size(), 3U * 110U);
      EXPECT_LE(excerpt.caret, 3U + 2U * 61U);
    }
  }
}

TEST(Utf8, IsCutBetweenCharacters) {
  using diagnostics::first_bytes;
  const std::string text = "a\xC3\xA4\xE2\x88\x92\xF0\x9F\x99\x82";
  const std::vector<std::size_t> sizes{0, 1, 1, 3, 3, 3, 6, 6, 6, 6, 10, 10};
  for (std::size_t most = 0; most < sizes.size(); ++most) {
    EXPECT_EQ(first_bytes(text, most).size(), sizes[most]) << most;
  }
  EXPECT_EQ(first_bytes("\x80\x80\x80\x80\x80\x80", 5).size(), 5U) << "no UTF-8";
}

}  // namespace
}  // namespace kerf::parser
