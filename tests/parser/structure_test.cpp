#include "parser/flow/structure.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "parser/flow/program_text.hpp"

namespace kerf::parser {
namespace {

void take(ProgramText& text, std::string_view lines) {
  LineSplitter splitter;
  splitter.feed(lines);
  splitter.finish();
  NumberedLine line;
  while (!text.closed() && splitter.next(line)) {
    text.take(line);
  }
  text.close();
}

// The faults of a text as `line: message`.
std::vector<std::string> faults_of(std::string_view lines, Dialect dialect = Dialect::rs274) {
  ProgramText text({.dialect = dialect});
  take(text, lines);
  std::vector<std::string> result;
  for (const StatementFault& fault : text.take_faults()) {
    result.push_back(std::to_string(text.number_of(fault.line)) + ": " + fault.message);
  }
  return result;
}

using Faults = std::vector<std::string>;

TEST(Structure, FindsTheCloseOfEachOpener) {
  ProgramText text({});
  take(text,
       "o1 while [1]\no2 if [1]\no2 elseif [2]\no2 else\no2 endif\no3 do\no3 while [0]\n"
       "o4 repeat [2]\no4 break\no4 endrepeat\no1 endwhile\n");
  const auto line_of_close = [&](std::uint32_t line) {
    return text.statement(text.statement(text.line(line).statement).close).line;
  };
  EXPECT_EQ(line_of_close(0), 10U);
  EXPECT_EQ(line_of_close(1), 4U);
  EXPECT_EQ(line_of_close(5), 6U);
  EXPECT_EQ(line_of_close(7), 9U);
  EXPECT_EQ(text.statement(text.line(6).statement).keyword, Keyword::o_do_while);
  EXPECT_EQ(text.statement(text.line(8).statement).head, text.line(7).statement);
  EXPECT_FALSE(text.has_faults());
}

TEST(Structure, TakesALabelAgainOnceItsStructureIsClosed) {
  EXPECT_EQ(faults_of("o1 if [1]\no1 endif\no1 if [1]\no1 endif\no1 while [0]\no1 endwhile\n"),
            Faults{});
  EXPECT_EQ(faults_of("o1 sub\no5 if [1]\no5 endif\no1 endsub\no5 if [1]\no5 endif\n"), Faults{});
}

TEST(Structure, IgnoresCaseBlanksAndLeadingZeros) {
  EXPECT_EQ(faults_of("o007WHILE[1]\nO 7 end while\no<Foo Bar> IF [1]\no<foobar>endif\n"),
            Faults{});
}

TEST(Structure, NamesWhatIsNeverClosedAtItsOpener) {
  EXPECT_EQ(faults_of("G0\no100 if [1 GT 0]\nG1\n"), Faults{"2: o100 if has no endif"});
  EXPECT_EQ(faults_of("o1 while [1]\no2 do\no1 endwhile\n"), Faults{"2: o2 do has no while"});
  EXPECT_EQ(faults_of("o<a> sub\no2 repeat [3]\no<a> endsub\n"),
            Faults{"2: o2 repeat has no endrepeat"});
  EXPECT_EQ(faults_of("o1 sub\nM2\n%\no1 endsub"), Faults{"1: o1 sub has no endsub"});
}

TEST(Structure, BlamesTheOpenerForACloseWithAnotherLabel) {
  EXPECT_EQ(faults_of("\no100 while [1]\n\no101 endwhile\n"),
            Faults{"2: o101 endwhile in line 4 does not close o100 while"});
}

TEST(Structure, NamesWhatFitsNowhere) {
  EXPECT_EQ(faults_of("o1 else"), Faults{"1: o1 else without if"});
  EXPECT_EQ(faults_of("o1 endif"), Faults{"1: o1 endif without if"});
  EXPECT_EQ(faults_of("o100 endsub"), Faults{"1: o100 endsub without sub"});
  EXPECT_EQ(faults_of("o100 break"), Faults{"1: break outside a loop"});
  EXPECT_EQ(faults_of("o1 while [1]\no2 continue\no1 endwhile"),
            Faults{"2: o2 continue: no loop around it has this label"});
  EXPECT_EQ(faults_of("o1 while [1]\no2 sub\no1 break\no2 endsub\no1 endwhile"),
            Faults{"3: break outside a loop"});
  EXPECT_EQ(faults_of("o100 return"), Faults{"1: return outside a sub"});
  EXPECT_EQ(faults_of("o1 if [1]\no1 else\no1 elseif [1]\no1 endif"),
            Faults{"3: o1 elseif after the else of this if"});
}

TEST(Structure, RefusesSubsInsideEachOtherAndTwice) {
  EXPECT_EQ(faults_of("o100 sub\no200 sub\no200 endsub\no100 endsub\n"),
            Faults{"2: sub inside sub o100"});
  EXPECT_EQ(faults_of("o3 sub\no3 endsub\no3 sub\no3 endsub\n"),
            Faults{"3: o3 is defined twice, first in line 1"});
}

TEST(Structure, BoundsTheNesting) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) {
    text += "o1 if [1]\n";
  }
  const Faults faults = faults_of(text);
  EXPECT_EQ(faults[0], "65: structures are nested too deep (at most 64)");
}

TEST(Structure, SaysOnceThatItIsTooDeepAndLooksNoFurther) {
  std::string text;
  for (int i = 0; i < 200'000; ++i) {
    text += "o" + std::to_string(i) + " if [1]\n";
  }
  for (int i = 0; i < 200'000; ++i) {
    text += "o" + std::to_string(i + 1'000'000) + " endif\n";
  }
  EXPECT_EQ(faults_of(text), (Faults{"65: structures are nested too deep (at most 64)"}));
}

TEST(Structure, PairsTheLoopsOfMacros) {
  const auto fanuc = [](std::string_view lines) { return faults_of(lines, Dialect::fanuc); };
  EXPECT_EQ(fanuc("WHILE[#1LT3]DO1\nN5 WHILE [1] DO 2\nEND2\nEND1\nDO1\nEND 1 (c)\n"), Faults{});
  EXPECT_EQ(fanuc("WHILE[#1LT3]DO1"), Faults{"1: DO1 has no END1"});
  EXPECT_EQ(fanuc("WHILE[1]DO1\nWHILE[1]DO2\n#1=1\nEND1\nEND2"),
            Faults{"1: END1 closes DO1 while DO2 is open"});
  EXPECT_EQ(fanuc("END1"), Faults{"1: END1 without DO1"});
  EXPECT_EQ(fanuc("WHILE[1]DO4\n"), Faults{"1: DO: the loop's number must be 1, 2 or 3, found 4"});
  EXPECT_EQ(fanuc("WHILE[1]DO1\nDO1\nEND1\nEND1"), Faults{"2: DO1 inside DO1"});
  EXPECT_EQ(fanuc("IF[#1EQ0]"), Faults{"1: THEN or GOTO is expected after IF [...]"});
  EXPECT_EQ(fanuc("O1\nDO1\nO2\nEND1"), (Faults{"2: DO1 has no END1", "4: END1 without DO1"}));
}

}  // namespace
}  // namespace kerf::parser
