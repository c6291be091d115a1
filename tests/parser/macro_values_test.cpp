// Values in Fanuc's dialect. Sources: [B-64304EN, chapter 16] (custom macro).
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/parser/values.hpp"

namespace kerf::parser {
namespace {

class MacroValue : public testing::Test, public Blocks {
 protected:
  MacroValue() : Blocks(Dialect::fanuc) {}

  std::string value_of(const std::string& expression) { return x_of("X[" + expression + "]"); }
};

TEST_F(MacroValue, AndBindsLikeAProductAndOrLikeASum) {
  EXPECT_EQ(value_of("1 OR 2 AND 2"), "3");
  EXPECT_EQ(value_of("12 AND 10"), "8");
  EXPECT_EQ(value_of("12 XOR 10"), "6");
  EXPECT_EQ(value_of("2+3*4"), "14");
  EXPECT_EQ(value_of("1+2 GT 2"), "1");
}

TEST_F(MacroValue, FixGoesTowardsZeroAndFupAway) {
  EXPECT_EQ(value_of("FIX[-1.2]"), "-1");
  EXPECT_EQ(value_of("FUP[-1.2]"), "-2");
  EXPECT_EQ(value_of("FIX[1.2]"), "1");
  EXPECT_EQ(value_of("FUP[1.2]"), "2");
}

TEST_F(MacroValue, FunctionsHaveFanucsForms) {
  EXPECT_EQ(value_of("ATAN[1]"), "45");
  EXPECT_EQ(value_of("ATAN[-1]/[-1]"), "225");
  EXPECT_EQ(value_of("ATAN[1,-1]"), "135");
  EXPECT_EQ(value_of("POW[2,10]"), "1024");
  EXPECT_EQ(value_of("BCD[10]"), "16");
  EXPECT_EQ(value_of("BIN[16]"), "10");
  x_of("#1=RO[2.5]+FI[3.9]");
  EXPECT_EQ(x_of("X#1"), "6");
  EXPECT_EQ(value_of("POW[2]"), "3: POW needs the form POW[base,exponent]");
  EXPECT_EQ(value_of("BIN[10]"), "3: BIN needs eight decimal digits at most, found 10");
  EXPECT_EQ(value_of("2**3"), "4: an operator or ']' is expected, found '*'");
}

TEST_F(MacroValue, AssignmentsNeedNoBracketsAndTakeEffectAtOnce) {
  EXPECT_EQ(x_of("#1=2+3*4"), "no X");
  EXPECT_EQ(x_of("N20 #2 = #1 / 2 (half)"), "no X");
  EXPECT_EQ(x_of("X#2"), "7");
  EXPECT_EQ(x_of("#1=5 G0 X1"), "1: an assignment must stand alone in its block");
}

TEST_F(MacroValue, AWordWithAVacantValueIsLeftOut) {
  EXPECT_EQ(x_of("G0 X#1 Y5"), "no X");
  EXPECT_EQ(block.value('Y'), 5.0);
  EXPECT_EQ(x_of("X-#1"), "no X");
  EXPECT_EQ(x_of("X[#1]"), "no X");
  EXPECT_EQ(x_of("#2=#1"), "no X");
  EXPECT_EQ(x_of("X#2"), "no X");
  EXPECT_EQ(x_of("X[#1+0]"), "0");
}

TEST_F(MacroValue, AVacantVariableEqualsOnlyAnother) {
  EXPECT_EQ(value_of("#1 EQ #0"), "1");
  EXPECT_EQ(value_of("#1 NE 0"), "1");
  EXPECT_EQ(value_of("#1 EQ 0"), "0");
  EXPECT_EQ(value_of("#1 GE 0"), "1");
  EXPECT_EQ(value_of("#1 GT 0"), "0");
}

TEST_F(MacroValue, VariablesHaveFanucsRanges) {
  EXPECT_EQ(x_of("#0=1"), "1: variable #0 is read-only");
  EXPECT_EQ(x_of("#34=1"), "1: variable #34 does not exist");
  EXPECT_EQ(x_of("X#200"), "2: variable #200 does not exist");
}

}  // namespace
}  // namespace kerf::parser
