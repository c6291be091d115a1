// Where the program's coordinates lie on the machine: G54 to G59.3, G52, G92, G43, and with Fanuc
// G54.1, G51, G51.1 and G68, in one place.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "parser/moves/move.hpp"

namespace kerf::parser {

using kerf::WorkOffset;

// G51: distances from the centre are taken times the factors; a negative one mirrors.
struct Scaling {
  Point centre_mm{};  // in program coordinates
  Point factor{1.0, 1.0, 1.0};

  [[nodiscard]] double scaled(std::size_t axis, double coordinate_mm) const {
    return centre_mm[axis] + factor[axis] * (coordinate_mm - centre_mm[axis]);
  }

  friend bool operator==(const Scaling&, const Scaling&) = default;
};

// G68: a turn of the program about a line along Z.
struct ProgramTurn {
  Point centre_mm{};  // in program coordinates; Z is not used
  double angle_deg = 0.0;

  friend bool operator==(const ProgramTurn&, const ProgramTurn&) = default;
};

// G51.1: the axes that are mirrored, each about a place of its own.
struct Mirror {
  Point about_mm{};  // in program coordinates
  std::array<bool, 3> mirrored{};

  friend bool operator==(const Mirror&, const Mirror&) = default;
};

// machine = turn(mirror(turn68(scale51(program))) + local) + origin + tool
//
// turn and origin are those of the chosen work offset, local is G52 or G92, tool is G43. This is
// the order in which LinuxCNC applies them: a local offset lies in the turned axes, the tool's does
// not. As long as all of it is zero `plain()` says so, and nobody needs to compute anything.
class Coordinates {
 public:
  static constexpr std::size_t kSystems =
      kWorkSystems;                              // 0: G54 ... 5: G59, 6: G59.1, 7: G59.2, 8: G59.3
  static constexpr std::size_t kExtended = 300;  // after these: G54.1 P1 ... P300

  [[nodiscard]] bool plain() const { return plain_; }
  // A move along X or Y of the program moves both axes of the machine.
  [[nodiscard]] bool turned() const { return x_from_y_ != 0.0 || y_from_x_ != 0.0; }
  // G51 or G51.1 turns the sense of arcs in the plane round.
  [[nodiscard]] bool mirrors(Plane plane) const {
    const auto one = [this](std::size_t axis) {
      return mirror_.mirrored[axis] != (scaling_.factor[axis] < 0.0);
    };
    return plane == Plane::xy   ? one(0) != one(1)
           : plane == Plane::zx ? one(2) != one(0)
                                : one(1) != one(2);
  }
  // G51 or G68 is in force.
  [[nodiscard]] bool scaled_or_turned() const {
    return scaling_ != Scaling{} || turn_ != ProgramTurn{};
  }
  // The same, or G51.1 is.
  [[nodiscard]] bool shaped() const { return scaled_or_turned() || mirror_ != Mirror{}; }

  [[nodiscard]] std::size_t system() const { return system_; }
  // Precondition of these four: system < kSystems + kExtended.
  // Selecting the system in force changes nothing.
  void select(std::size_t system);
  [[nodiscard]] const WorkOffset& work(std::size_t system) const;
  // A change of the chosen system takes effect at once.
  void set_work(std::size_t system, const WorkOffset& offset);
  // Takes effect when the system is chosen the next time.
  void store_work(std::size_t system, const WorkOffset& offset);

  [[nodiscard]] const Point& local_mm() const { return local_mm_; }
  [[nodiscard]] const AuxiliaryWords& local_auxiliary_deg_mm() const {
    return local_auxiliary_deg_mm_;
  }
  void set_local(const Point& local_mm, const AuxiliaryWords& auxiliary_deg_mm = {});
  [[nodiscard]] const Point& tool_mm() const { return tool_mm_; }
  void set_tool(const Point& tool_mm);

  [[nodiscard]] const Scaling& scaling() const { return scaling_; }
  // Precondition: no factor is 0.
  void set_scaling(const Scaling& scaling);
  [[nodiscard]] const ProgramTurn& program_turn() const { return turn_; }
  void set_program_turn(const ProgramTurn& turn);
  [[nodiscard]] const Mirror& mirror() const { return mirror_; }
  void set_mirror(const Mirror& mirror);

  [[nodiscard]] Point to_machine(const Point& program_mm) const;
  [[nodiscard]] Point to_program(const Point& machine_mm) const;
  // The same for the auxiliary axes, which are only moved, by local + origin.
  [[nodiscard]] AuxiliaryWords auxiliary_to_machine(const AuxiliaryWords& program_deg_mm) const;
  [[nodiscard]] AuxiliaryWords auxiliary_to_program(const AuxiliaryWords& machine_deg_mm) const;
  // The program's X of a machine point is per_x x + per_y y + at_origin_mm.
  struct ProgramX {
    double per_x = 1.0;
    double per_y = 0.0;
    double at_origin_mm = 0.0;
  };
  [[nodiscard]] ProgramX program_x() const;
  // A distance along the program's axes as one along the machine's.
  [[nodiscard]] Point turned_to_machine(const Point& distance_mm) const;

 private:
  void refresh();

  std::array<WorkOffset, kSystems> work_{};
  std::vector<WorkOffset> extended_;  // as far as any was written
  std::size_t system_ = 0;
  WorkOffset chosen_{};
  Point local_mm_{};
  AuxiliaryWords local_auxiliary_deg_mm_{};
  Point tool_mm_{};
  Scaling scaling_{};
  ProgramTurn turn_{};
  Mirror mirror_{};

  // Of the above, for the block: machine = matrix * program + shift. Z stays by itself.
  bool plain_ = true;
  double x_from_x_ = 1.0;
  double x_from_y_ = 0.0;
  double y_from_x_ = 0.0;
  double y_from_y_ = 1.0;
  double z_from_z_ = 1.0;
  Point shift_mm_{};
};

// The cosine and sine of a turn in degrees, exact for whole quarter turns.
struct Turn {
  double cosine = 1.0;
  double sine = 0.0;
};
Turn turn_from_degrees(double degrees);

}  // namespace kerf::parser
