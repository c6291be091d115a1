// What a program uses beside its own text: the dialect, block delete switches, subprograms, and the
// machine's offsets and tools.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <kerf/api.hpp>
#include <kerf/axes.hpp>
#include <tl/expected.hpp>

namespace kerf {
inline namespace v0 {

/// The language of a program.
enum class Dialect : std::uint8_t {
  rs274,  ///< RS274/NGC as LinuxCNC reads it
  fanuc,  ///< program numbers, custom macro B, Fanuc's meaning of shared codes
};

/// What a program tells the operator. RS274/NGC alone; of several comments of a block the last one.
struct ProgramMessage {
  enum class Kind : std::uint8_t {
    message,  ///< (MSG, text)
    print,    ///< (PRINT, text), with `#1` and `#<name>` as numbers of six decimals
    debug,    ///< (DEBUG, text), the same
  };
  Kind kind = Kind::message;
  std::uint32_t line = 0;
  std::string text{};
};

/// The operator's block delete switches: which blocks with a '/' before them are left out. Nine
/// switches, as Fanuc has them: /2 belongs to the second, a '/' alone to the first.
class BlockDelete {
 public:
  static constexpr unsigned kSwitches = 9;

  /// None is on: every block runs.
  constexpr BlockDelete() = default;
  /// All are on: no block with a '/' runs.
  static constexpr BlockDelete all() {
    BlockDelete switches;
    for (unsigned number = 1; number <= kSwitches; ++number) {
      switches.switch_on(number);
    }
    return switches;
  }
  /// Precondition: 1 <= number <= kSwitches.
  constexpr void switch_on(unsigned number) {
    on_ = static_cast<std::uint16_t>(on_ | (1U << number));
  }

  /// The same precondition.
  [[nodiscard]] constexpr bool is_on(unsigned number) const { return ((on_ >> number) & 1U) != 0; }

  /// Whether the line, which has a '/' at byte `at` (0-based, < line.size()), is left out.
  [[nodiscard]] constexpr bool leaves_out(std::string_view line, std::size_t at) const {
    if (on_ == 0) {
      return false;
    }
    ++at;
    while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) {
      ++at;
    }
    const char c = at < line.size() ? line[at] : '1';
    const unsigned number = c >= '1' && c <= '9' ? static_cast<unsigned>(c - '0') : 1U;
    return is_on(number);
  }

  friend constexpr bool operator==(BlockDelete, BlockDelete) = default;

 private:
  std::uint16_t on_ = 0;  ///< bit n is switch n
};

/// A subprogram of another file.
struct SubprogramText {
  std::string file;  ///< its name, for messages
  std::string text;
  std::string refused{};  ///< why it is not read; empty: it is
};
/// The whole text of a subprogram that is not in the program itself, by its name in lower case
/// ("pocket" of `o<Pocket> call`, "1000" of M98 P1000); nothing where there is none.
using SubprogramSource = std::function<std::optional<SubprogramText>(std::string_view name)>;

/// Which of the machine's inputs the feedrate follows (Kernel::set_feed_inputs). Nothing: none.
struct FeedInputNumbers {
  std::optional<std::int32_t> adaptive_feed{};  ///< analog, 0 to 7: a share of the feedrate, M52
  std::optional<std::int32_t> feed_stop{};      ///< digital, 0 to 63: high, the tool holds, M53
};

/// Letters as a set, one bit each.
using Letters = std::uint32_t;
constexpr Letters letter_bit(char upper_case) {
  return Letters{1} << (upper_case - 'A');
}

/// Values of the auxiliary axes as a program has them: A, B, C in degrees, U, V, W in mm.
using AuxiliaryWords = std::array<double, kAuxiliaryAxes>;

/// The origin of a work coordinate system and its turn about Z through that origin.
struct WorkOffset {
  Position origin_mm{};           ///< in machine coordinates
  double rotation_deg = 0.0;      ///< counterclockwise, as G10 L2 R gives it
  AuxiliaryWords extra_deg_mm{};  ///< the origin of the extra axes
};

/// One row of the tool table.
struct Tool {
  std::int32_t number = 0;  ///< T; 0 is the empty spindle
  std::int32_t pocket = 0;  ///< P
  Position offset_mm{};     ///< X Y Z; a mill has its length in Z
  double diameter_mm = 0.0;
  double front_angle_deg = 0.0;  ///< of turning tools, as I, J and Q are
  double back_angle_deg = 0.0;
  std::int32_t orientation = 0;
  double length_wear_mm = 0.0;  ///< of Fanuc; part of offset_mm
  double radius_wear_mm = 0.0;  ///< part of diameter_mm / 2
};

/// Kept by tool number. A table that nobody gave knows every tool: all have length and diameter 0.
/// T0, the empty spindle, is in every table.
class KERF_API ToolTable {
 public:
  static constexpr std::int32_t kHighestNumber = 99'999;

  ToolTable() = default;  ///< nobody gave one

  /// True: the tools that were put in are all there are.
  [[nodiscard]] bool given() const { return given_; }
  void set_given() { given_ = true; }

  /// The tool, with all offsets zero where a table that nobody gave does not list it. Null: the
  /// table has no such tool. The pointer is good until the table changes.
  [[nodiscard]] const Tool* find(std::int32_t number) const;
  /// Adds the tool, or replaces the one with its number.
  void put(const Tool& tool);
  [[nodiscard]] const std::vector<Tool>& listed() const { return tools_; }

 private:
  std::vector<Tool> tools_;  ///< by number
  bool given_ = false;
};

/// What is wrong with the text of a tool table.
struct ToolTableError {
  std::uint32_t line = 0;    ///< 1-based
  std::uint32_t column = 0;  ///< 1-based
  std::string message;
};

/// Reads LinuxCNC's tool table, one tool a line in mm: `T1 P1 X0 Z12.5 D10 ;remark`. T must be
/// there, P is T where it is missing, everything else is 0; I, J and Q describe turning tools.
/// Blank lines and lines that begin with ';' say nothing.
//
/// Errors: no T; T, P or Q not whole or outside 0..99999; a word twice or with no value, an unknown
/// one; an offset of an axis other than X, Y and Z; a negative D; an offset beyond 999999.999 mm; a
/// tool listed twice.
KERF_API tl::expected<ToolTable, std::vector<ToolTableError>> read_tool_table(
    std::string_view text);

/// Where G30 goes.
struct HomePosition {
  Position mm{};  ///< in machine coordinates
  AuxiliaryWords extra_deg_mm{};
};

enum class PathMode : std::uint8_t { exact_path, exact_stop, blend };  ///< G61, G61.1, G64

/// How exactly the programmed path is kept.
struct PathControl {
  PathMode mode = PathMode::exact_path;
  double corner_tolerance_mm = 0.0;  ///< P of G64, >= 0; 0: no corner is rounded
  double merge_tolerance_mm = 0.0;   ///< Q of G64, >= 0; 0: no lines are merged

  friend bool operator==(const PathControl&, const PathControl&) = default;
};

/// A path control under which motion of a program ran.
struct PathControlUse {
  PathControl control{};
  bool by_program = false;  ///< it names the mode; else the machine does

  friend bool operator==(const PathControlUse&, const PathControlUse&) = default;
};

inline constexpr std::size_t kWorkSystems = 9;  ///< 0: G54 ... 5: G59, 6: G59.1, 7: G59.2, 8: G59.3

/// The machine's data for its programs.
struct ProgramData {
  std::array<WorkOffset, kWorkSystems> work{};  ///< G54 to G59.3
  Position first_home_mm{};                     ///< G28, in machine coordinates
  Position second_home_mm{};                    ///< G30
  Letters extra_axes = 0;                       ///< those of A, B, C, U, V, W that the machine has
  AuxiliaryWords first_home_extra_deg_mm{};
  AuxiliaryWords second_home_extra_deg_mm{};
  std::array<HomePosition, 2> further_homes{};  ///< Fanuc: G30 P3, P4
  ToolTable tools;
  /// Fanuc dialect: the unit of a number without a decimal point, in mm, 0 to 1; 0: millimetres.
  double least_increment_mm = 0.0;
  /// The tolerances of a G64 without P: of corners and, if Q is missing too, of merged lines; >= 0.
  double corner_tolerance_mm = 0.01;
  double merge_tolerance_mm = 0.01;
  /// In force until a program names a mode. Here G61, so that nothing departs from the path
  /// unasked; machine files and the default machine begin in G64 with the two tolerances above.
  PathControl path_control{};
  FeedInputNumbers feed_inputs{};
  double tool_change_s = 0.0;  ///< of an M6 that waits for no answer, >= 0
  /// To where Z goes up before a program that starts in its middle moves over the work; at most the
  /// travel's top, which it is where this is infinite.
  double safe_z_mm = kUnbounded;
  double spindle_start_s = 0.0;  ///< rest after an M3 or M4 that starts the spindle, >= 0
  /// After M3, M4 and a new S the tool rests until the machine says that the spindle is at its
  /// speed (ProgramInputs), where KernelOptions::asks_machine.
  bool waits_for_spindle = false;
};

/// Of the default machine: no offsets, and a tool changer with 60 places. T1 (10 mm, 12.5 mm long),
/// T2 (6 mm) and T3 (20 mm, -3 mm) are measured, the others have length and diameter 0.
KERF_API ProgramData default_program_data();

}  // namespace v0
}  // namespace kerf
