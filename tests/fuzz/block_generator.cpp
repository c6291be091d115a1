#include "tests/fuzz/block_generator.hpp"

#include <array>

namespace kerf::fuzz {

namespace {

constexpr std::array kNumbers{"0",
                              "1",
                              "2",
                              "-1",
                              "10",
                              "0.5",
                              ".25",
                              "5.",
                              "+3",
                              "-0.0",
                              "25.4",
                              "99999",
                              "1000000",
                              "999999.999",
                              "-999999.999",
                              "0.0001",
                              "1e3",
                              "--1",
                              "1 0",
                              "100",
                              "3",
                              "360",
                              "0.000000000000000000001",
                              "4",
                              "7",
                              "123456789012345678901234567890",
                              "1.2.3",
                              ".",
                              "-"};
constexpr std::array kCodes{
    "G0",    "G1",    "G2",  "G3",    "G4",    "G5",    "G5.1",  "G5.2",  "G5.3",  "G6.2",  "G10",
    "G17",   "G18",   "G19", "G20",   "G21",   "G28",   "G28.1", "G30",   "G30.1", "G38.2", "G38.3",
    "G38.4", "G38.5", "G40", "G41",   "G41.1", "G42",   "G42.1", "G43",   "G43.1", "G43.2", "G49",
    "G52",   "G53",   "G54", "G55",   "G59.3", "G54.1", "G61",   "G61.1", "G64",   "G65",   "G68",
    "G69",   "G50",   "G51", "G73",   "G74",   "G80",   "G81",   "G82",   "G83",   "G84",   "G85",
    "G86",   "G89",   "G90", "G90.1", "G91",   "G91.1", "G92",   "G92.1", "G92.2", "G92.3", "G93",
    "G94",   "G95",   "G96", "G97",   "G98",   "G99",   "M0",    "M1",    "M2",    "M3",    "M4",
    "M5",    "M6",    "M7",  "M8",    "M9",    "M19",   "M30",   "M48",   "M49",   "M50",   "M51",
    "M52",   "M53",   "M61", "M62",   "M63",   "M64",   "M65",   "M66",   "M67",   "M68",   "M70",
    "M71",   "M72",   "M73", "M97",   "M98",   "M99",   "G05",   "G05.1", "G06.2", "G77",   "M300"};
constexpr std::array kFunctions{"abs", "acos", "asin",  "cos", "exp",  "fix",
                                "fup", "ln",   "round", "sin", "sqrt", "tan"};
constexpr std::array kOperators{"+",     "-",    "*",    "/",    "**",   " mod ", " and ", " or ",
                                " xor ", " eq ", " ne ", " gt ", " ge ", " lt ",  " le "};
constexpr std::array kNames{"a", "b", "_x", "_value", "_feed", "deep name", "_line", "_call_level"};
constexpr char kLetters[] = "XYZXYZXYZFSTPQRIJKLDHNABCUVWE";

}  // namespace

std::string BlockGenerator::number() {
  if (one_in(2)) {
    return kNumbers[below(kNumbers.size())];
  }
  return std::to_string(static_cast<int>(below(4001)) - 2000) + "." + std::to_string(below(1000));
}

std::string BlockGenerator::parameter() {
  switch (below(5)) {
    case 0:
      return std::string("#<") + kNames[below(kNames.size())] + ">";
    case 1:
      return "#[" + expression(1) + "]";
    case 2:
      return "#" + std::to_string(5060 + below(400));
    case 3:
      return "##" + std::to_string(below(5));
    default:
      return "#" + std::to_string(below(35));
  }
}

std::string BlockGenerator::operand(int depth) {
  switch (below(depth > 0 ? 6 : 2)) {
    case 0:
      return parameter();
    case 2:
      return "[" + expression(depth - 1) + "]";
    case 3:
      return std::string(kFunctions[below(kFunctions.size())]) + "[" + expression(depth - 1) + "]";
    case 4:
      return "atan[" + expression(depth - 1) + "]/[" + expression(depth - 1) + "]";
    case 5:
      return "-" + operand(depth - 1);
    default:
      return number();
  }
}

std::string BlockGenerator::expression(int depth) {
  std::string text = operand(depth);
  for (std::uint32_t more = below(3); more > 0; --more) {
    text += kOperators[below(kOperators.size())] + operand(depth);
  }
  return text;
}

std::string BlockGenerator::value() {
  switch (below(8)) {
    case 0:
      return "[" + expression(3) + "]";
    case 1:
      return parameter();
    default:
      return number();
  }
}

std::string BlockGenerator::word() {
  if (one_in(4)) {
    return kCodes[below(kCodes.size())];
  }
  return std::string(1, kLetters[below(sizeof kLetters - 1)]) + value();
}

std::string BlockGenerator::assignment() {
  return parameter() + (one_in(20) ? "" : "=") + (one_in(3) ? "[" + expression(2) + "]" : number());
}

std::string BlockGenerator::block() {
  std::string text;
  if (one_in(12)) {
    text += one_in(3) ? "/2" : "/";
  }
  if (one_in(6)) {
    text += "N" + std::to_string(below(50)) + " ";
  }
  for (std::uint32_t words = 1 + below(5); words > 0; --words) {
    text += one_in(12) ? assignment() : word();
    text += one_in(3) ? "" : " ";
  }
  if (one_in(15)) {
    text += one_in(2) ? "(a (note)" : "; rest";
  }
  return text + "\n";
}

std::string BlockGenerator::body(int depth) {
  std::string text;
  for (std::uint32_t count = below(4); count > 0; --count) {
    text += depth > 0 && one_in(3) ? (one_in(2) ? o_word_group(depth - 1) : macro_group(depth - 1))
                                   : block();
  }
  return text;
}

std::string BlockGenerator::o_word_group(int depth) {
  const std::string o = one_in(4) ? "o<ring>" : "o" + std::to_string(100 + below(6));
  const std::string condition = "[" + expression(1) + "]\n";
  const std::string inner = body(depth);
  switch (below(9)) {
    case 0:
      return o + " if " + condition + inner + o + " endif\n";
    case 1:
      return o + " if " + condition + inner + o + " else\n" + inner + o + " endif\n";
    case 2:
      return o + " if " + condition + o + " elseif " + condition + inner + o + " endif\n";
    case 3:
      return o + " while " + condition + inner + o + " endwhile\n";
    case 4:
      return o + " do\n" + inner + o + " while " + condition;
    case 5:
      return o + " repeat " + condition + inner + o + " endrepeat\n";
    case 6:
      return o + " sub\n" + inner + o + " return [" + expression(1) + "]\n" + o + " endsub\n" + o +
             " call " + value() + " [" + expression(1) + "]\n";
    case 7:
      return o + (one_in(2) ? " break\n" : " continue\n");
    default:
      return o + " call [" + expression(1) + "]\n";
  }
}

std::string BlockGenerator::macro_group(int depth) {
  const std::string number = std::to_string(1 + below(4));
  const std::string label = std::to_string(below(50));
  const std::string condition = "[" + expression(1) + "]";
  switch (below(7)) {
    case 0:
      return "WHILE" + condition + "DO" + number + "\n" + body(depth) + "END" + number + "\n";
    case 1:
      return "IF" + condition + "GOTO" + label + "\n" + body(depth) + "N" + label + "\n";
    case 2:
      return "IF" + condition + "THEN " + assignment() + "\n";
    case 3:
      return "O" + label + "\n" + body(depth) + "M99\n";
    case 4:
      return "M98 P" + label + (one_in(2) ? " L" + number : "") + "\n";
    case 5:
      return "G65 P" + label + " A" + value() + " B" + value() + "\n";
    default:
      return "GOTO" + label + "\n";
  }
}

std::string BlockGenerator::curve() {
  std::string text = "G6.2 P" + std::to_string(2 + below(4)) + " K0 X0 Y0\n";
  for (std::uint32_t points = below(7); points > 0; --points) {
    text += "K" + std::to_string(below(3)) + " X" + number() + " Y" + number() +
            (one_in(3) ? " R" + number() : "") + "\n";
  }
  for (std::uint32_t knots = below(6); knots > 0; --knots) {
    text += "K3\n";
  }
  return text;
}

std::string BlockGenerator::cycle() {
  std::string text = one_in(2) ? "G98 " : "G99 ";
  text += "G8" + std::to_string(1 + below(9)) + " X1 Y2 Z-5 R1 P0.5 Q" + number();
  text += one_in(3) ? " L" + number() + "\n" : "\n";
  return text + "X" + value() + "\nG80\n";
}

std::string BlockGenerator::lines() {
  switch (below(8)) {
    case 0:
      return o_word_group(2);
    case 1:
      return macro_group(2);
    case 2:
      return curve();
    case 3:
      return cycle();
    case 4:
      return "G41 D1 G1 X0 Y0\n" + block() + block() + "G40 G1 X0\n";
    default:
      return block();
  }
}

}  // namespace kerf::fuzz
