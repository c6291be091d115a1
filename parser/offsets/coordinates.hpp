// Where the program's coordinates lie on the machine: G54 to G59.3, G52, G92, G43 in one place.
#pragma once

#include <array>
#include <cstddef>

#include "parser/move.hpp"

namespace kerf::parser {

// The origin of a work coordinate system and its turn about Z through that origin.
struct WorkOffset {
  Point origin_mm{};          // in machine coordinates
  double rotation_deg = 0.0;  // counterclockwise, as G10 L2 R gives it
};

// machine = turn(program + local) + origin + tool
//
// turn and origin are those of the chosen work offset, local is G52 or G92, tool is G43. This is
// the order in which LinuxCNC applies them: a local offset lies in the turned axes, the tool's does
// not. As long as all of it is zero `plain()` says so, and nobody needs to compute anything.
class Coordinates {
 public:
  static constexpr std::size_t kSystems = 9;  // 0: G54 ... 5: G59, 6: G59.1, 7: G59.2, 8: G59.3

  [[nodiscard]] bool plain() const { return plain_; }
  // The axes X and Y of the program are not those of the machine.
  [[nodiscard]] bool turned() const { return sine_ != 0.0 || cosine_ != 1.0; }

  [[nodiscard]] std::size_t system() const { return system_; }
  // Precondition of these four: system < kSystems. The one in force is not read anew.
  void select(std::size_t system);
  [[nodiscard]] const WorkOffset& work(std::size_t system) const { return work_[system]; }
  // A change of the chosen system takes effect at once.
  void set_work(std::size_t system, const WorkOffset& offset);
  // Takes effect when the system is chosen the next time.
  void store_work(std::size_t system, const WorkOffset& offset) { work_[system] = offset; }

  [[nodiscard]] const Point& local_mm() const { return local_mm_; }
  void set_local(const Point& local_mm);
  [[nodiscard]] const Point& tool_mm() const { return tool_mm_; }
  void set_tool(const Point& tool_mm);

  [[nodiscard]] Point to_machine(const Point& program_mm) const;
  [[nodiscard]] Point to_program(const Point& machine_mm) const;
  // A distance along the program's axes as one along the machine's.
  [[nodiscard]] Point turned_to_machine(const Point& distance_mm) const;

  // The local offset with which the tool's place `machine_mm` has the program coordinates
  // `program_mm`: what G92 sets.
  [[nodiscard]] Point local_for(const Point& machine_mm, const Point& program_mm) const;

 private:
  void refresh();

  std::array<WorkOffset, kSystems> work_{};
  std::size_t system_ = 0;
  WorkOffset chosen_{};
  Point local_mm_{};
  Point tool_mm_{};

  // Of the above, for the block: machine = turn(program) + shift.
  bool plain_ = true;
  double cosine_ = 1.0;
  double sine_ = 0.0;
  Point shift_mm_{};
};

// The cosine and sine of a turn in degrees, exact for whole quarter turns.
struct Turn {
  double cosine = 1.0;
  double sine = 0.0;
};
Turn turn_from_degrees(double degrees);

}  // namespace kerf::parser
