// The tools that a machine has, and their offsets.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "parser/moves/move.hpp"

namespace kerf::parser {

struct Tool {
  std::int32_t number = 0;  // T; 0 is the empty spindle
  std::int32_t pocket = 0;  // P
  Point offset_mm{};        // X Y Z; a mill has its length in Z
  double diameter_mm = 0.0;
  double front_angle_deg = 0.0;  // of turning tools, as I, J and Q are
  double back_angle_deg = 0.0;
  std::int32_t orientation = 0;
  double length_wear_mm = 0.0;  // of Fanuc; part of offset_mm
  double radius_wear_mm = 0.0;  // part of diameter_mm / 2
};

// Kept by tool number. A table that nobody gave knows every tool: all have length and diameter 0.
// T0, the empty spindle, is in every table.
class ToolTable {
 public:
  static constexpr std::int32_t kHighestNumber = 99'999;

  ToolTable() = default;  // nobody gave one

  // True: the tools that were put in are all there are.
  [[nodiscard]] bool given() const { return given_; }
  void set_given() { given_ = true; }

  // The tool, with all offsets zero where a table that nobody gave does not list it. Null: the
  // table has no such tool. The pointer is good until the table changes.
  [[nodiscard]] const Tool* find(std::int32_t number) const;
  // Adds the tool, or replaces the one with its number.
  void put(const Tool& tool);
  [[nodiscard]] const std::vector<Tool>& listed() const { return tools_; }

 private:
  std::vector<Tool> tools_;  // by number
  bool given_ = false;
};

struct ToolTableError {
  std::uint32_t line = 0;    // 1-based
  std::uint32_t column = 0;  // 1-based
  std::string message;
};

// Reads LinuxCNC's tool table, one tool a line in mm: `T1 P1 X0 Z12.5 D10 ;remark`. T must be
// there, P is T where it is missing, everything else is 0; I, J and Q describe turning tools.
// Blank lines and lines that begin with ';' say nothing.
//
// Errors: no T, T or P not whole or outside 0..99999, a word twice or with no value, an axis that
// the machine does not have, a negative D, an offset beyond 999999.999 mm, a tool listed twice.
tl::expected<ToolTable, std::vector<ToolTableError>> read_tool_table(std::string_view text);

}  // namespace kerf::parser
