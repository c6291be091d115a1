// O-words, subprograms and M98 in the RS274/NGC dialect; tests/conformance/flow compares them with
// LinuxCNC.
#include <map>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/parser/flow_program.hpp"

namespace kerf::parser {
namespace {

TEST(Flow, BreakAndContinueWorkInEveryLoop) {
  const std::string body =
      "#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\no3 if [#1 EQ 4]\no1 break\no3 endif\n"
      "G0 X#1\n";
  EXPECT_EQ(path_of("o1 while [#1 LT 9]\n" + body + "o1 endwhile\nG0 X9"), "1 3 9");
  EXPECT_EQ(path_of("o1 do\n" + body + "o1 while [#1 LT 9]\nG0 X9"), "1 3 9");
  EXPECT_EQ(path_of("o1 repeat [8]\n" + body + "o1 endrepeat\nG0 X9"), "1 3 9");
}

TEST(Flow, LeavesAnOuterLoopFromAnInnerOne) {
  EXPECT_EQ(path_of("o1 repeat [3]\no2 repeat [3]\n#1=[#1+1]\nG0 X#1\no3 if [#1 EQ 2]\n"
                    "o1 continue\no3 endif\no4 if [#1 EQ 4]\no1 break\no4 endif\no2 endrepeat\n"
                    "o1 endrepeat\nG0 X9"),
            "1 2 3 4 9");
}

TEST(Flow, CountsRepeatsAnewInEachCall) {
  EXPECT_EQ(path_of("G91\no1 sub\no2 repeat [2]\nG0 X1\no3 if [#1 GT 0]\no1 call [#1-1]\no3 endif\n"
                    "o2 endrepeat\no1 endsub\no4 repeat [2]\no1 call [1]\no4 endrepeat"),
            "1 2 3 4 5 6 7 8 9 10 11 12");
}

TEST(Flow, KeepsTheLocalsOfACallApart) {
  EXPECT_EQ(path_of("#1=7 #31=8\no1 sub\nG0 X#1\n#1=20 #31=30\no1 endsub\no1 call [3]\nG0 X#1\n"
                    "G0 X#31"),
            "3 7 30");
}

TEST(Flow, GivesBackAValueOrNone) {
  EXPECT_EQ(path_of("o1 sub\no1 return [5]\no1 endsub\no2 sub\no2 endsub\no1 call\n"
                    "G0 X[#<_value>+#<_value_returned>]\no2 call\nG0 X[1+#<_value>]\n"
                    "G0 X[2+#<_value_returned>]"),
            "6 1 2");
}

TEST(Flow, SaysSoWhereAFileOnlyDefinesSubprograms) {
  const std::string sub = "(hole)\n\no<hole> sub\nG1 Z-5 F100\no<hole> endsub\n";
  const std::string message =
      "3:1: warning: the program defines subprograms and calls none: nothing is run\n";
  EXPECT_EQ(messages_of(sub + "M2\n"), message);
  EXPECT_EQ(messages_of("%\n" + sub + "%\n"),
            "4:1: warning: the program defines subprograms and calls none: nothing is run\n");
  EXPECT_NE(messages_of(sub).find(message), std::string::npos);
  EXPECT_EQ(messages_of(sub + "o<hole> call\nM2\n"), "");
  EXPECT_EQ(messages_of(sub + "G4 P1\nM2\n"), "");
  EXPECT_EQ(messages_of("M2\n"), "") << "nothing to call";
  EXPECT_EQ(messages_of("#1=1\no4 sub\n#3=1\no4 endsub\no4 call\nM2\n"), "") << "no motion";
}

TEST(Flow, CallsItself) {
  EXPECT_EQ(path_of("o1 sub\no2 if [#1 GT 0]\nG0 X#1\no1 call [#1-1]\nG0 X[10+#1]\no2 endif\n"
                    "o1 endsub\no1 call [3]"),
            "3 2 1 11 12 13");
}

TEST(Flow, ThirtyTwoCallsDeepIsTheLimit) {
  const std::string recursion =
      "o1 sub\no2 if [#1 GT 1]\no1 call [#1-1]\no2 endif\no1 endsub\nG0 X1\n";
  EXPECT_EQ(path_of(recursion + "o1 call [32]\nG0 X2"), "1 2");
  EXPECT_EQ(messages_of(recursion + "o1 call [33]\nG0 X2\nM2\n"),
            "3:4: error: subprogram calls are nested too deep (at most 32)\n");
}

TEST(Flow, KnowsTheNumberOfTheLineThatIsRead) {
  EXPECT_EQ(path_of("G0 X#<_line>\n"
                    "o1 sub\n"
                    "X[#<_line>+#1]\n"
                    "o1 endsub\n"
                    "o2 if [#<_line> EQ 4]\n"
                    "X99\n"
                    "o2 elseif [#<_line> EQ 7]\n"
                    "X#<_line>\n"
                    "o2 endif\n"
                    "o1 call [#<_line>*100]\n"
                    "o3 repeat [2]\n"
                    "X[100+#<_line>]\n"
                    "o3 endrepeat"),
            "1 8 1003 112");
}

TEST(Flow, StopsALoopThatNeverMoves) {
  ReaderOptions options;
  options.max_idle_steps = 1000;
  const auto message = [&](std::string_view text) { return messages_of(text, options); };
  EXPECT_EQ(message("G0 X1\no1 while [1]\n#1=[1+1]\no1 endwhile\nM2\n"),
            "2:1: error: the loop ran 1000 lines without motion: it is taken to be endless\n");
  EXPECT_EQ(message("G0 X1\no1 while [1]\nM8\no1 endwhile\nM2\n"),
            "2:1: error: the loop ran 1000 lines without motion: it is taken to be endless\n")
      << "what the machine does at rest is no motion";
  EXPECT_EQ(message("G91 G1 F1\no1 while [1]\nX[1/10**12]\no1 endwhile\nM2\n"),
            "2:1: error: the loop ran 1000 lines without motion: it is taken to be endless\n")
      << "a move of 1e-10 mm, which a hundred steps add up to, is none either";
  EXPECT_EQ(message("o1 while [1]\nG91 G0 X1\nX1 Q5\no1 endwhile\nM2\n"),
            "3:4: error: Q is not used in this block\n"
            "1:1: error: the loop ran 1000 lines after an error: it is taken to be endless\n")
      << "the moves of a program with an error are in vain";
  std::string long_program = "o1 if [1]\no1 endif\nG91 G0 X1 Q5\n";
  for (int i = 0; i < 1500; ++i) {
    long_program += "G0 X1\n";
  }
  EXPECT_EQ(message(long_program + "M2\n"), "3:11: error: Q is not used in this block\n");
  EXPECT_EQ(message("#1=0\no1 while [#1 LT 900]\n#1=[#1+1]\nG0 X#1\no1 endwhile\nM2\n"), "");
}

TEST(Flow, SkipsWhatItDoesNotRun) {
  EXPECT_EQ(path_of("o1 if [0]\nG0 X1 typing error\no1 else\nG0 X2\no1 endif"), "2");
  EXPECT_EQ(path_of("o1 sub\nG0 X1\no1 endsub\nG0 X2"), "2");
  EXPECT_EQ(path_of("o1 while [0]\nG0 X1\no1 endwhile\nG0 X2"), "2");
}

TEST(Flow, EndsTheProgramInsideOfAnything) {
  EXPECT_EQ(path_of("o1 sub\no2 while [1]\nG0 X1\nM2\no2 endwhile\no1 endsub\no1 call\nG0 X2"),
            "1");
}

TEST(Flow, FindsWhatIsLeftOpenBehindTheEnd) {
  EXPECT_EQ(messages_of("o1 if [1]\nG0 X1\nM2\n"), "1:4: error: o1 if has no endif\n");
  EXPECT_EQ(messages_of("G0 X1\no1 sub\nM2\n"), "2:4: error: o1 sub has no endsub\n");
  EXPECT_EQ(messages_of("o1 if [1]\nG0 X1\nM2\no1 endif\n"), "");
}

TEST(Flow, SaysWhatIsWrongWithAStatement) {
  EXPECT_EQ(messages_of("O\nM2\n"),
            "1:1: error: a number, a <name> or an [expression] is expected after 'O'\n");
  EXPECT_EQ(messages_of("o100 frobnicate\nM2\n"),
            "1:6: error: o100: 'frobnicate' is not known (sub, call, if, while ...)\n");
  EXPECT_EQ(messages_of("G1 X5 F100 o100 call\nM2\n"),
            "1:12: error: an o-word must be the first word of a block\n");
  EXPECT_EQ(messages_of("o777 call [1]\nM2\n"), "1:6: error: sub o777 is not found\n");
  EXPECT_EQ(messages_of("o1 if [1] G0 X1\no1 endif\nM2\n"),
            "1:11: error: only a comment may follow here, found 'G0 X1'\n");
  EXPECT_EQ(messages_of("o1 while\no1 endwhile\nM2\n"),
            "1:9: error: 'while' needs a value in [ ]\n");
  EXPECT_EQ(messages_of("o1 repeat [0-3]\nG0 X1\no1 endrepeat\nM2\n"),
            "1:4: warning: the repeat count is negative (-3): nothing is repeated\n");
  EXPECT_EQ(messages_of("o[1.5] call\nM2\n"),
            "1:2: error: the label must be a whole number, found 1.5\n");
}

TEST(Flow, SaysAFaultInsideALoopOnce) {
  EXPECT_EQ(messages_of("o1 repeat [50]\nG0 X1 R4\nG0 X2\no1 endrepeat\nM2\n"),
            "2:7: error: R is not used in this block\n");
}

TEST(Subprogram, M98SharesTheParametersOfItsCaller) {
  EXPECT_EQ(path_of("#1=3\nM98 P100 L2\nG0 X#1\nM2\nO100\n#1=[#1+1]\nG0 X[10+#1]\nM99"), "14 15 5");
}

TEST(Subprogram, M98RunsTheOtherWordsOfItsBlockFirst) {
  EXPECT_EQ(path_of("G0 X1 M98 P100\nG0 X3\nM2\nO100\nG0 X2\nM99"), "1 2 3");
}

TEST(Subprogram, M99EndsTheMainProgramWithAWarning) {
  EXPECT_EQ(messages_of("G0 X1\nM99\nG0 X2\n"),
            "2:1: warning: M99 in the main program: it would repeat without end and is ended here\n"
            "3:1: warning: blocks after the program's end are never executed\n");
}

TEST(Subprogram, ThatIsWrongBehindTheEndFailsNoProgramHoweverTheTextCame) {
  const std::string program = "o1 sub\nG0 X7\no1 endsub\no1 call\nM2\n";
  const std::string behind = "o2 sub\nG0 X1\no1 sub\n";
  EXPECT_NE(messages_of(program + behind).find("error"), std::string::npos);
  for (const bool is_whole : {true, false}) {
    ProgramReader reader{ReaderOptions{}};
    reader.feed(is_whole ? program + behind : program);
    Move move;
    while (reader.next(move)) {
    }
    EXPECT_TRUE(reader.at_end());
    EXPECT_FALSE(reader.has_errors());
  }
}

TEST(Subprogram, ThatIsLeftOpenAtTheEndFailsTheProgram) {
  ProgramReader reader{ReaderOptions{}};
  reader.feed("G0 X1\no1 if [1]\nM2\n");
  Move move;
  while (reader.next(move)) {
  }
  EXPECT_FALSE(reader.at_end());
  reader.feed("G0 X2\n");
  reader.finish();
  while (reader.next(move)) {
  }
  EXPECT_TRUE(reader.has_errors());
}

TEST(Subprogram, SaysWhatIsWrongWithACall) {
  EXPECT_EQ(messages_of("M98\nM2\n"), "1:1: error: M98 needs P (the subprogram's number)\n");
  EXPECT_EQ(messages_of("M98 P\nM2\n"),
            "1:5: error: a number is expected after address 'P', found the end of the line\n");
  EXPECT_EQ(messages_of("M98 P9999\nM2\n"), "1:1: error: program O9999 is not found\n");
  EXPECT_EQ(messages_of("M98 P100\nM2\no100 sub\no100 endsub\n"),
            "1:1: error: O100 begins with sub: call it with `o100 call`\n");
  EXPECT_EQ(messages_of("o100 call\nM2\nO100\nM99\n"),
            "1:6: error: O100 is no sub: call it with M98 P100\n");
  EXPECT_EQ(messages_of("M98 P100\nM2\nO100\nG0 X5\nM98 P100\nM99\n"),
            "5:1: error: subprogram calls are nested too deep (at most 32)\n");
  EXPECT_EQ(messages_of("M98 P100\nM2\nO100\nG0 X5\nO101\nM99\n"),
            "5:2: error: the subprogram before this one has no M99\n");
}

TEST(Subprogram, ComesFromAFileBesideTheProgram) {
  const ReaderOptions options = with_files({{"mysub",
                                             "%\no<mysub> sub\nG0 X#1\no<h> call\n"
                                             "o<mysub> endsub [2*#1]\no<h> sub\nG0 X8\n"
                                             "o<h> endsub\n%\n"},
                                            {"123", "O123\nG0 X5\nM99\n"},
                                            {"124", "G0 X6\nM99\n"}});
  EXPECT_EQ(path_of("o<MySub> call [3]\nG0 X#<_value>\nM98 P123 L2\nM98 P124\nG0 X1", options),
            "3 8 6 5 6 1");
}

TEST(Subprogram, ItsFaultsNameItsFile) {
  const ReaderOptions options =
      with_files({{"bad", "o<bad> sub\nG0 X1 R2\no<bad> endsub\n"}, {"open", "o<open> sub\n"}});
  EXPECT_EQ(messages_of("\no<bad> call\nG0 X2 R3\nM2\n", options),
            "bad.ngc:2:7: error: R is not used in this block\n"
            "3:7: error: R is not used in this block\n");
  EXPECT_EQ(messages_of("o<open> call\nM2\n", options),
            "open.ngc:1:9: error: o<open> sub has no endsub\n");
}

TEST(Subprogram, ItsMovesNameItsFile) {
  const ReaderOptions options = with_files({{"s", "o<s> sub\nG0 X1\no<s> endsub\n"}});
  const Program program = read_program("o<s> call\nG0 X2\nM2\n", options);
  ASSERT_EQ(program.moves.size(), 3U);
  EXPECT_EQ(program.moves[0].source.file, 1U);
  EXPECT_EQ(program.moves[0].source.line, 2U);
  EXPECT_EQ(program.moves[1].source.file, 0U);
}

TEST(Flow, GivesTheSameHoweverTheTextIsCut) {
  const ReaderOptions options = with_files({{"s", "o<s> sub\nG0 X#1\no<s> endsub\n"}});
  for (const std::string_view text :
       {"o1 while [#1 LT 3]\n#1=[#1+1]\no2 if [#1 EQ 2]\nG0 X1\no2 else\nG0 X2 R1\no2 endif\n"
        "o1 endwhile\nM98 P5\no<s> call [4]\nM2\nO5\no5 repeat [2]\nG0 X5\no5 endrepeat\nM99\n",
        "o7 call [3]\no8 if [0]\no8 endif\nM2\no7 sub\nG0 X#1\no9 if [1]\no7 endsub\n",
        "o1 do\nG0 X1\no1 break\no1 while [1]\n%\no1 endif\n", "o1 if [0]\n", "M98 P4\nM2\nO5\n"}) {
    const std::string whole = everything(read_program(text, options));
    for (std::size_t piece = 1; piece < text.size(); ++piece) {
      EXPECT_EQ(everything(read_program(text, options, piece)), whole) << text << piece;
    }
  }
}

TEST(Flow, HoldsNoTextWithoutFlow) {
  ProgramReader reader;
  Move move;
  for (int i = 0; i < 10'000; ++i) {
    reader.feed("N10 G0 X1\nX2 (o1 while)\n");
    while (reader.next(move)) {
    }
  }
  EXPECT_EQ(reader.held_bytes(), 0U);
}

TEST(Flow, HoldsNoMoreThanTheTextAndALittleForEachLine) {
  ProgramReader reader;
  Move move;
  const std::string piece = "o1 repeat [3]\nG0 X1.25 Y17.125\nG0 X2.25 Y18.125\no1 endrepeat\n";
  std::size_t fed = 0;
  while (fed < 20'000'000) {
    reader.feed(piece);
    fed += piece.size();
    while (reader.next(move)) {
    }
  }
  EXPECT_LT(reader.held_bytes(), 5 * fed) << "every other line is a statement here";
}

TEST(Flow, KeepsTextOnlyFromTheFirstStatementOn) {
  ProgramReader reader;
  Move move;
  for (int i = 0; i < 100'000; ++i) {
    reader.feed("G0 X1.25 Y17.125\nG0 X2.25 Y18.125\n");
    while (reader.next(move)) {
    }
  }
  reader.feed("o1 if [1]\no1 endif\n");
  while (reader.next(move)) {
  }
  EXPECT_GT(reader.held_bytes(), 0U);
  EXPECT_LT(reader.held_bytes(), 1'000'000U);
}

}  // namespace
}  // namespace kerf::parser
