// Values of words. Where no other source is named, the values wanted are rs274's of LinuxCNC 2.9.
#include "parser/expressions/evaluator.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "program.hpp"
#include "tests/parser/values.hpp"

namespace kerf::parser {
namespace {

std::string x_of(const std::string& line, Dialect dialect = Dialect::rs274) {
  return Blocks(dialect).x_of(line);
}

TEST(Expression, BindsByLevelsFromLeftToRight) {
  EXPECT_EQ(x_of("X[2**3**2]"), "64");
  EXPECT_EQ(x_of("X[-2**2]"), "4");
  EXPECT_EQ(x_of("X[2*3 MOD 4]"), "2");
  EXPECT_EQ(x_of("X[2+3*4-1]"), "13");
  EXPECT_EQ(x_of("X[2-3-4]"), "-5");
  EXPECT_EQ(x_of("X[2/4/2]"), "0.25");
  EXPECT_EQ(x_of("X[1--3]"), "4");
  EXPECT_EQ(x_of("X[1-+3]"), "-2");
  EXPECT_EQ(x_of("X[1+1 EQ 2]"), "1");
  EXPECT_EQ(x_of("X[1 EQ 1 EQ 0]"), "0");
  EXPECT_EQ(x_of("X[5 GT 3 EQ 1]"), "1");
}

TEST(Expression, LogicalOperatorsShareOneLevel) {
  EXPECT_EQ(x_of("X[1 OR 0 AND 0]"), "0");
  EXPECT_EQ(x_of("X[0 AND 0 OR 1]"), "1");
  EXPECT_EQ(x_of("X[1 XOR 1 OR 1]"), "1");
  EXPECT_EQ(x_of("X[2 GT 1 AND 1 GT 2 OR 1]"), "1");
  EXPECT_EQ(x_of("X[3 XOR 4]"), "0");
  EXPECT_EQ(x_of("X[1 AND -1]"), "1");
}

TEST(Expression, ComparesForEqualityWithinATenThousandth) {
  EXPECT_EQ(x_of("X[1 EQ 1.00009]"), "1");
  EXPECT_EQ(x_of("X[1 EQ 1.00011]"), "0");
  EXPECT_EQ(x_of("X[1 NE 1.00005]"), "0");
  EXPECT_EQ(x_of("X[1 LE 0.99995]"), "0");
  EXPECT_EQ(x_of("X[1 GE 1.00005]"), "0");
  EXPECT_EQ(x_of("X[1 LT 1.00005]"), "1");
}

TEST(Expression, HasTheFunctionsInDegrees) {
  EXPECT_EQ(x_of("X-SIN[30]"), "-0.5");
  EXPECT_EQ(x_of("XATAN[1]/[-1]"), "135");
  EXPECT_EQ(x_of("XATAN[-1]/[-1]"), "-135");
  EXPECT_EQ(x_of("XATAN[0]/[-1]"), "180");
  EXPECT_EQ(x_of("X[ABS[-3]+ACOS[0]+ASIN[1]]"), "183");
  EXPECT_EQ(x_of("XROUND[2.5]"), "3");
  EXPECT_EQ(x_of("XROUND[-2.5]"), "-3");
  EXPECT_EQ(x_of("XFIX[-2.8]"), "-3");
  EXPECT_EQ(x_of("XFUP[-2.8]"), "-2");
  EXPECT_EQ(x_of("X[-7 MOD 3]"), "2");
  EXPECT_EQ(x_of("X[7 MOD -3]"), "1");
  EXPECT_EQ(x_of("XLN[EXP[2]]"), "2");
}

// Exact values, which a conversion to radians misses.
TEST(Expression, AnglesAtQuartersAreExact) {
  Blocks blocks;
  for (const char* const zero : {"X[SIN[180]]", "X[COS[90]]", "X[COS[-270]]", "X[TAN[360]]"}) {
    blocks.x_of(zero);
    EXPECT_EQ(blocks.block.value('X'), 0.0) << zero;
  }
}

TEST(Expression, IgnoresCaseAndBlanks) {
  EXPECT_EQ(x_of("X[ 4 m O d 3 ]"), "1");
  EXPECT_EQ(x_of("Xs in [30]"), "0.5");
  EXPECT_EQ(x_of("X - [ 3 ]"), "-3");
  EXPECT_EQ(x_of("X[1AND2eq2]"), "1");
}

TEST(Expression, ReadsVariables) {
  Blocks blocks;
  EXPECT_EQ(blocks.x_of("#1=2 #2=9"), "no X");
  EXPECT_EQ(blocks.x_of("X#1"), "2");
  EXPECT_EQ(blocks.x_of("X-#1"), "-2");
  EXPECT_EQ(blocks.x_of("X##1"), "9");
  EXPECT_EQ(blocks.x_of("X#[#1-0.00005]"), "9");
  EXPECT_EQ(blocks.x_of("X##[#1-1]"), "9");
  EXPECT_EQ(blocks.x_of("#<Some Name>=[#2*2]"), "no X");
  EXPECT_EQ(blocks.x_of("X#<somename>Y#1Z#2"), "18");
  EXPECT_EQ(blocks.block.value('Y'), 2.0);
  EXPECT_EQ(blocks.x_of("##1=5"), "no X");
  EXPECT_EQ(blocks.x_of("X#2"), "5");
  EXPECT_EQ(blocks.x_of("X[EXISTS[#<somename>]+EXISTS[#<other>]]"), "1");
  EXPECT_EQ(blocks.x_of("XEXISTS[#5]"), "1");
}

TEST(Assignment, TakesEffectBehindTheBlock) {
  Blocks blocks;
  blocks.x_of("#1=5 G0 X#1");
  EXPECT_EQ(blocks.block.value('X'), 0.0);
  EXPECT_EQ(blocks.block.stale_read, 10U);
  EXPECT_EQ(blocks.x_of("G0 X#1"), "5");
  EXPECT_EQ(blocks.block.stale_read, 0U);
  blocks.x_of("#1=1 #2=#1 #1=3");
  EXPECT_EQ(blocks.parameters.get(2), 5.0);
  EXPECT_EQ(blocks.parameters.get(1), 3.0);
}

TEST(Assignment, MayUseItsOwnVariable) {
  Blocks blocks;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(blocks.x_of("#<n>=[EXISTS[#<n>]+1] #1=[#1+1]"), "no X");
    EXPECT_EQ(blocks.block.stale_read, 0U);
  }
  EXPECT_EQ(blocks.parameters.get(1), 5.0);
  EXPECT_EQ(blocks.parameters.get("n"), 2.0);
}

TEST(Assignment, ThatFailsIsNotReportedAgainWhereItsNameIsUsed) {
  Blocks blocks;
  EXPECT_EQ(blocks.x_of("#<depth>=[1/0]"), "12: division by zero");
  EXPECT_EQ(blocks.x_of("X#<depth>"), "0");
}

TEST(Word, RoundsACodeToItsTenth) {
  Blocks blocks;
  blocks.x_of("G[1.00005] G[38.2+0.00001] M[3.00005] T[6.99995]");
  EXPECT_EQ(blocks.block.g[0].value, 1.0);
  EXPECT_EQ(blocks.block.g[1].value, 38.2);
  EXPECT_EQ(blocks.block.m[0].value, 3.0);
  EXPECT_EQ(blocks.block.value('T'), 7.0);
  blocks.x_of("G[1.0005]");
  EXPECT_EQ(blocks.block.g[0].value, 1.0005);
}

TEST(Word, TellsWhetherItsNumberHasAPoint) {
  Blocks blocks;
  blocks.x_of("X1 Y1. Z.5 A1 0 B1 0.5 C[1] U#1 V-7");
  EXPECT_EQ(blocks.block.pointed, letters('Y', 'Z', 'B', 'C', 'U'));
}

TEST(Expression, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(x_of("X[1/0]"), "4: division by zero");
  EXPECT_EQ(x_of("X[2+[3-5 MOD [2-2]]]"), "10: division by zero in MOD");
  EXPECT_EQ(x_of("X[SQRT[-4]]"), "3: SQRT of a negative number (-4)");
  EXPECT_EQ(x_of("X[1+ACOS[1.5]]"), "5: ACOS: the argument must be -1 to 1, found 1.5");
  EXPECT_EQ(x_of("X[LN[0]]"), "3: LN: the argument must be greater than 0, found 0");
  EXPECT_EQ(x_of("X[[-8]**0.5]"), "7: a negative number is raised to a fractional power");
  EXPECT_EQ(x_of("X[EXP[1000]]"), "3: the result is not finite");
  EXPECT_EQ(x_of("XTAN[90]"), "2: TAN has no value at 90 degrees");
  EXPECT_EQ(x_of("X[ATAN[1]]"), "3: ATAN needs the form ATAN[a]/[b]");
  EXPECT_EQ(x_of("X[SINH[1]]"), "3: function SINH is not known");
  EXPECT_EQ(x_of("XSINH[1]"), "2: function SINH is not known");
  EXPECT_EQ(x_of("X[SIN 30]"), "7: '[' is expected after SIN, found '30'");
  EXPECT_EQ(x_of("X[]"), "3: the expression is empty");
  EXPECT_EQ(x_of("X[1+]"), "5: an operand is expected after '+', found ']'");
  EXPECT_EQ(x_of("X[1 MOD]"), "8: an operand is expected after 'MOD', found ']'");
  EXPECT_EQ(x_of("X[2**"), "6: an operand is expected after '**', found the end of the line");
  EXPECT_EQ(x_of("X[1 2]"), "5: an operator or ']' is expected, found '2'");
  EXPECT_EQ(x_of("X[1 FOO 2]"), "5: an operator or ']' is expected, found 'FOO'");
  EXPECT_EQ(x_of("X[1=2]"), "4: an operator or ']' is expected, found '=' (EQ compares)");
  EXPECT_EQ(x_of("X[1+2 (note)"), "7: ']' is expected, found a comment");
  EXPECT_EQ(x_of("X[1.2.3]"), "3: malformed number '1.2.3': more than one decimal point");
  EXPECT_EQ(x_of("X[--3]"), "4: malformed number '--': more than one sign");
  EXPECT_EQ(x_of("X1+2]"), "3: unexpected character '+' after number 1");
  EXPECT_EQ(x_of("X[1]+2"), "5: operator '+' outside of brackets: an expression stands in [ ]");
}

TEST(Variable, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(x_of("G1 X#99999"), "5: variable #99999 does not exist");
  EXPECT_EQ(x_of("#0=1"), "1: variable #0 does not exist");
  EXPECT_EQ(x_of("#99999999999999999999=1"), "1: variable #1000000000 does not exist");
  EXPECT_EQ(x_of("#-5=1"), "1: a variable's number must not be negative, found -5");
  EXPECT_EQ(x_of("#1.5=1"), "1: a variable's number must be whole, found 1.5");
  EXPECT_EQ(x_of("#5420=1"), "1: variable #5420 is read-only");
  EXPECT_EQ(x_of("#1 2"), "4: '=' is expected after '#1'");
  EXPECT_EQ(x_of("#1="), "4: a value is expected after '=', found the end of the line");
  EXPECT_EQ(x_of("X#"), "3: a variable's number is expected after '#', found the end of the line");
  EXPECT_EQ(x_of("# a note"), "3: a variable's number is expected after '#', found 'a'");
  EXPECT_EQ(x_of("X#<not_set>"), "2: variable #<not_set> is not set");
  EXPECT_EQ(x_of("X#<depth"), "9: '>' is expected to close '#<'");
  EXPECT_EQ(x_of("#1=#2+3"), "6: operator '+' outside of brackets: an expression stands in [ ]");
  EXPECT_EQ(x_of("#1=2*3"), "5: operator '*' outside of brackets: an expression stands in [ ]");
  EXPECT_EQ(x_of("X[EXISTS[5]]"), "10: EXISTS needs the form EXISTS[#<name>]");
}

TEST(Expression, NestsSixtyFourLevelsDeep) {
  const auto nested = [](int levels) {
    const auto count = static_cast<std::size_t>(levels);
    return "X" + std::string(count, '[') + "1" + std::string(count, ']');
  };
  EXPECT_EQ(x_of(nested(64)), "1");
  const std::string message = "brackets are nested too deep: at most 64 levels are allowed";
  EXPECT_EQ(x_of(nested(65)), "67: " + message);
  EXPECT_EQ(x_of(nested(30000)), "67: " + message);
  EXPECT_EQ(x_of("X" + std::string(60000, '#')), "67: " + message);
  std::string functions = "X";
  std::string signs = "X[";
  for (int i = 0; i < 5000; ++i) {
    functions += "SIN[";
    signs += "-";
  }
  EXPECT_EQ(x_of(functions), "262: " + message);
  EXPECT_EQ(x_of(signs), "4: malformed number '--': more than one sign");
}

TEST(Expression, AgreesWithLinuxCNCOnRandomOnes) {
  std::ifstream file(KERF_SOURCE_DIR "/tests/parser/expressions/ngc_values.tsv");
  Blocks blocks;
  std::string line;
  int count = 0;
  while (std::getline(file, line)) {
    if (line.rfind("# variables", 0) == 0) {
      std::istringstream pairs(line.substr(11));
      for (int number = 0; pairs >> number;) {
        double value = 0.0;
        pairs >> value;
        blocks.parameters.set(number, value);
        blocks.parameters.set("v" + std::to_string(number), value);
      }
    } else if (line[0] != '#' || line.find('\t') != std::string::npos) {
      const std::size_t tab = line.find('\t');
      const std::string text = "X[" + line.substr(0, tab) + "]";
      const double wanted = std::stod(line.substr(tab + 1));
      ASSERT_TRUE(read_block(text, blocks.block, blocks.evaluator))
          << text << ": " << explain_stop(blocks.block).message;
      EXPECT_NEAR(blocks.block.value('X'), wanted, 2e-9 * std::fmax(1.0, std::fabs(wanted)))
          << text;
      ++count;
    }
  }
  EXPECT_EQ(count, 1000);
}

}  // namespace
}  // namespace kerf::parser
