// Program numbers, custom macro B and macro calls of the Fanuc dialect. Expected values from the
// manual's rules: no Fanuc control answers here.
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/parser/flow_program.hpp"

namespace kerf::parser {
namespace {

ReaderOptions fanuc() {
  ReaderOptions options;
  options.dialect = Dialect::fanuc;
  return options;
}
std::string path(const std::string& text) {
  return path_of(text, fanuc());
}
std::string fanuc_messages(std::string_view text) {
  return messages_of(text, fanuc());
}

TEST(FanucFlow, CallsAProgramOfTheSameFile) {
  EXPECT_EQ(path("%\nO1000 (MAIN)\nG0 X1\nM98 P2000\nG0 X3\nM30\nO2000\nG0 X2\nM99\n%"), "1 2 3");
  EXPECT_EQ(path(":1000\nM98 P2000 L2\nM30\n:2000\nG91 G0 X1\nM99"), "1 2");
  EXPECT_EQ(path("O1\nM98 P32000\nM30\nO2000\nG91 G0 X1\nM99"), "1 2 3")
      << "repeats before a number of four digits";
}

TEST(FanucFlow, CallsABlockOfItsOwnProgram) {
  EXPECT_EQ(path("O1\nG0 X1\nM97 P15\nG0 X4\nM97 P15 L2\nM30\nN15 G91 G0 X1\nG90\nM99"),
            "1 2 4 5 6");
  EXPECT_EQ(fanuc_messages("O1\nM97 P15\nM30\n"), "2:1: error: N15 is not found in this program\n");
  EXPECT_EQ(fanuc_messages("O1\nM97\nM30\n"),
            "2:1: error: M97 needs P (the number of the block to go to)\n");
}

TEST(FanucFlow, GoesToANumberedBlock) {
  EXPECT_EQ(path("G0 X1\nGOTO 20\nG0 X2\nN20 G0 X3"), "1 3");
  EXPECT_EQ(path("N10 G0 X#1\n#1=#1+1\nIF [#1 LT 3] GOTO 10\nG0 X9"), "1 2 9")
      << "a vacant variable leaves the word out";
  EXPECT_EQ(path("#1=20\nGOTO #1\nG0 X2\nN20 G0 X3"), "3");
  EXPECT_EQ(path("#1=20\nGOTO [#1+10]\nN20 G0 X3\nN30 G0 X4"), "4");
}

TEST(FanucFlow, SearchesForwardFirstAndOnlyInItsProgram) {
  EXPECT_EQ(path("N10 #1=#1+1\nIF [#1 GT 1] GOTO 99\nGOTO 10\nN20 G0 X1\nN10 G0 X2\nN99 G0 X3"),
            "2 3");
  EXPECT_EQ(fanuc_messages("O1\nGOTO 10\nM30\nO2\nN10 G0 X1\nM99\n"),
            "2:6: error: N10 is not found in this program\n");
  EXPECT_EQ(path("O1\nM98 P2\nM30\nN10 G0 X9\nM30\nO2\nGOTO 10\nG0 X1\nN10 G0 X2\nM99"), "2");
}

TEST(FanucFlow, LoopsWhileAConditionHolds) {
  EXPECT_EQ(path("#1=0\nWHILE [#1 LT 3] DO1\n#1=#1+1\n#2=0\nWHILE [#2 LT 2] DO2\n#2=#2+1\n"
                 "G0 X[10*#1+#2]\nEND2\nEND1\nG0 X9"),
            "11 12 21 22 31 32 9");
  EXPECT_EQ(path("#1=0\nDO1\n#1=#1+1\nG0 X#1\nIF [#1 EQ 3] GOTO 5\nEND1\nN5 G0 X9"), "1 2 3 9");
  EXPECT_EQ(path("WHILE [1 EQ 0] DO1\nG0 X1\nEND1\nWHILE [1 EQ 0] DO1\nG0 X2\nEND1\nG0 X3"), "3");
}

TEST(FanucFlow, RunsTheRestOfALineThatBeginsWithAnIf) {
  EXPECT_EQ(path("IF [1 EQ 1] THEN #1=5\nIF [1 EQ 0] THEN #1=6\nG0 X#1"), "5");
  EXPECT_EQ(path("IF[1EQ1]THENG0X4\nN7 IF [1 EQ 1] THEN GOTO 9\nG0 X5\nN9 G0 X6"), "4 6");
  EXPECT_EQ(fanuc_messages("IF [1 EQ 1] THEN G0 X1 R2\nM30\n"),
            "1:24: error: R is not used in this block\n")
      << "columns stay what they are";
}

TEST(FanucFlow, RefusesFormsOfIfThatItDoesNotHave) {
  EXPECT_EQ(fanuc_messages("IF[1EQ1]THEN IF[1EQ1]THEN#2=3\nM30\n"),
            "1:14: error: IF cannot stand after THEN: write GOTO\n");
  EXPECT_EQ(fanuc_messages("IF[1EQ1]THEN WHILE[1EQ0]DO1\nM30\n"),
            "1:14: error: WHILE cannot stand after THEN: write GOTO\n");
  EXPECT_EQ(fanuc_messages("IF[1EQ1]THEN (HERE)\n#2=3\nELSE\n#2=4\nENDIF\nM30\n"),
            "1:13: error: THEN needs a statement after it in the same line\n"
            "3:1: error: ELSE and ENDIF are not supported: write IF [..] GOTO around the blocks\n"
            "5:1: error: ELSE and ENDIF are not supported: write IF [..] GOTO around the blocks\n");
}

TEST(FanucFlow, RaisesAlarmsAndStops) {
  EXPECT_EQ(fanuc_messages("IF [#18 EQ #0] THEN #3000=12(R IS MISSING)\nG0 X1 Q\nM30\n"),
            "1:21: error: the program raises alarm 3012 (R IS MISSING)\n");
  const Program program = read_program("G0 X1\n#3006=1(LOOK)\nG0 X2\nM30\n", fanuc());
  EXPECT_FALSE(program.has_errors);
  EXPECT_EQ(text_of(program.moves.at(1)), "2: program stop 0");
}

TEST(FanucFlow, PassesArgumentsByLetter) {
  const std::string macro = "M30\nO100\nG0 X#24\nG0 X#1\nG0 X#4\nG0 X#26\nG0 X#11\nM99";
  EXPECT_EQ(path("O1\nG65 P100 X1 A2 I3 Z4 H5\n" + macro), "1 2 3 4 5");
  EXPECT_EQ(path("O1\nG65 P100 L2 X[1+1] A#100 (A IS VACANT)\n" + macro).substr(0, 1), "2");
  EXPECT_EQ(path("O1\nG65 P100 A1 I2 J3 K4 I5 J6 K7 I8\nM30\nO100\nG0 X#4\nG0 X#5\nG0 X#6\n"
                 "G0 X#7\nG0 X#8\nG0 X#9\nG0 X#10\nM99"),
            "2 3 4 5 6 7 8");
}

TEST(FanucFlow, GivesAMacroItsOwnLocals) {
  EXPECT_EQ(path("O1\n#1=1\n#100=7\nG65 P100 A2\nG0 X#1\nG0 X#100\nM98 P200\nG0 X#1\nM30\n"
                 "O100\nG0 X#1\n#1=3\n#100=8\nM99\nO200\n#1=4\nM99"),
            "2 1 8 4");
}

TEST(FanucFlow, CallsAMacroAfterEachMove) {
  EXPECT_EQ(path("O1\nG66 P100 A5\nG0 X1\nG0 X2\nG67\nG0 X3\nM30\nO100\nG91\nG0 X#1\nG90\nM99"),
            "1 6 2 7 3");
}

TEST(FanucFlow, CallsMacrosAfterTheMovesOfMacros) {
  // 200 was given last, so it runs after X1; its own move calls 100, whose move calls nothing.
  const std::string macros = "M30\nO100\nG0 X100\nM99\nO200\nG0 X200\nM99";
  EXPECT_EQ(path("O1\nG66 P100\nG66 P200\nG0 X1\nG67\nG0 X2\nG67\nG0 X3\n" + macros),
            "1 200 100 2 100 3");
  EXPECT_EQ(path("O1\nG66 P100\nM98 P5\nG67\nG0 X2\nM30\nO5\nG0 X5\nM99\n" + macros), "5 100 2")
      << "moves of a subprogram call it too";
  EXPECT_EQ(fanuc_messages("O1\nG66 P100\nG66 P100\nG66 P100\nG66 P100\nG66 P100\n" + macros + "\n")
                .substr(0, 71),
            "6:1: error: at most 4 modal calls (G66) may be in force: cancel with G6");
}

TEST(FanucFlow, CallsProgramsByName) {
  EXPECT_EQ(path("O<MAIN>\nG0 X1\nM98 <Pocket 2> L2\nG65 <POCKET2> A7\nG66<POCKET2>\nG0X6\nG67\n"
                 "M30\nO<POCKET 2>\nG91 G0 X1\nG90\nM99"),
            "1 2 3 4 6 7");
  EXPECT_EQ(path_of("M98 <POCKET>\nM30",
                    [] {
                      ReaderOptions options = with_files({{"pocket", "O<POCKET>\nG0 X5\nM99\n"}});
                      options.dialect = Dialect::fanuc;
                      return options;
                    }()),
            "5");
  EXPECT_EQ(fanuc_messages("M98 <GONE>\nM30\n"), "1:1: error: program <gone> is not found\n");
  EXPECT_EQ(fanuc_messages("M98 <A> P1\nM30\nO<A>\nM99\n"),
            "1:9: error: M98: the program is given by its name and by P\n");
  EXPECT_EQ(fanuc_messages("G65 <A> P1\nM30\nO<A>\nM99\n"),
            "1:9: error: G65: the program is given by its name and by P\n");
  EXPECT_EQ(fanuc_messages("G0 <A>\nM30\n").substr(0, 11), "1:4: error:");
}

TEST(FanucFlow, M99GoesOnAtAnotherBlock) {
  EXPECT_EQ(path("O1\nM98 P2\nG0 X1\nN50 G0 X2\nM30\nO2\nG0 X5\nM99 P50"), "5 2");
  EXPECT_EQ(fanuc_messages("O1\n\n  M98 P2\nM30\nO2\nG0 X5\nN7 M99 P77\n"),
            "7:8: error: N77 is not found in the calling program\n");
  EXPECT_EQ(
      fanuc_messages("O1\nM98 P2\nWHILE [1 EQ 0] DO1\nN5 G0 X1\nEND1\nM30\nO2\nG0 X5\n M99 P5\n"),
      "9:6: error: N5 stands inside a loop: a jump into it is not allowed\n");
  EXPECT_EQ(fanuc_messages("O1\nG0 X1\nM99\n"),
            "3:1: warning: M99 in the main program: it would repeat without end and is ended "
            "here\n");
}

TEST(FanucFlow, SaysWhatIsWrong) {
  EXPECT_EQ(fanuc_messages("IF[1EQ1]GOTO999\nM2\n"),
            "1:13: error: N999 is not found in this program\n");
  EXPECT_EQ(fanuc_messages("WHILE[1EQ0]DO1\nM2\n"), "1:6: error: DO1 has no END1\n");
  EXPECT_EQ(fanuc_messages("GOTO 10\nWHILE[1EQ0]DO1\nN10 G0 X1\nEND1\nM30\n"),
            "1:6: error: N10 stands inside a loop: a jump into it is not allowed\n");
  EXPECT_EQ(fanuc_messages("G65 A1\nM30\n"), "1:1: error: G65 needs P\n");
  EXPECT_EQ(fanuc_messages("G65 P1 G1\nM30\n"), "1:8: error: G cannot be a macro argument\n");
  EXPECT_EQ(fanuc_messages("O1\nM98 P2\nM30\nO2\nG0 X1\n"),
            "5:1: error: the subprogram has no M99 before the end of the text\n");
  EXPECT_EQ(fanuc_messages("O1\nG0 X1\nO2\nG0 X2\nM30\n"),
            "3:2: warning: the program ends here, it has no M30, M2 or M99\n");
  EXPECT_EQ(fanuc_messages("o100 call\nM30\n"),
            "1:1: error: o100 call: o-words belong to RS274/NGC, not to the Fanuc dialect\n");
  EXPECT_EQ(fanuc_messages("O1\nM99 P\nM30\n"),
            "2:5: error: a number is expected after address 'P', found the end of the line\n");
  EXPECT_EQ(fanuc_messages("THEN #1=1\nM30\n"), "1:1: error: THEN without IF [..] before it\n");
  EXPECT_EQ(
      fanuc_messages("#<abc>=1\nM30\n"),
      "1:1: error: variable #<abc>: names belong to RS274/NGC, here variables have numbers\n");
  EXPECT_EQ(fanuc_messages("GOTO 1.5\nM30\n"),
            "1:6: error: GOTO: the sequence number must be a whole number from 1 to 999999999, "
            "found 1.5\n");
}

TEST(FanucFlow, StopsALoopThatNeverMoves) {
  ReaderOptions options = fanuc();
  options.max_idle_steps = 100;
  EXPECT_EQ(messages_of("G0 X1\nN5 #1=1\nGOTO 5\nM30\n", options),
            "2:1: error: the loop ran 100 lines without motion: it is taken to be endless\n");
}

TEST(FanucFlow, GivesTheSameHoweverTheTextIsCut) {
  for (const std::string_view text :
       {"%\nO1\nN10 G0 X#1\n#1=#1+1\nIF [#1 LT 3] GOTO 10\nM98 P2\nGOTO 30\nG0 X4\nN30 M30\nO2\n"
        "WHILE[#1 LT 6]DO1\n#1=#1+1\nG0 X#1\nEND1\nM99\n%\nrest\n",
        "GOTO 7\nM30\n", "G65 P5 A1\nM30\nO5\nIF[#1EQ1]THEN G0 X5\nM99", "\xEF\xBB\xBFO1\nM99\n"}) {
    const std::string whole = everything(read_program(text, fanuc()));
    for (std::size_t piece = 1; piece < text.size(); ++piece) {
      EXPECT_EQ(everything(read_program(text, fanuc(), piece)), whole) << text << piece;
    }
  }
}

TEST(FanucFlow, KeepsAtMostFourMegabytesBeforeTheFirstStatement) {
  ProgramReader reader(fanuc());
  Move move;
  std::size_t most = 0;
  for (int i = 0; i < 400'000; ++i) {
    reader.feed("N7 G0 X1.25 Y17.125\nG0 X2.25 Y18.125\n");
    while (reader.next(move)) {
    }
    most = std::max(most, reader.held_bytes());
  }
  EXPECT_LT(most, std::size_t{16} << 20U);
  EXPECT_EQ(reader.held_bytes(), 0U);
  reader.feed("GOTO 7\nM30\n");
  reader.finish();
  while (reader.next(move)) {
  }
  ASSERT_TRUE(reader.has_errors());
  EXPECT_EQ(reader.diagnostics()[0].message,
            "N7 is not found in the text that was kept (only 4 MiB are kept before the first macro "
            "statement)");
}

}  // namespace
}  // namespace kerf::parser
