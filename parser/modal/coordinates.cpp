#include "parser/modal/coordinates.hpp"

#include <cmath>

namespace kerf::parser {

namespace {

constexpr double kDegreesPerRadian = 57.295779513082320877;

Point sum(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point product(const Point& a, const Point& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}

Point turned_by(const Turn& turn, const Point& v) {
  return {turn.cosine * v[0] - turn.sine * v[1], turn.sine * v[0] + turn.cosine * v[1], v[2]};
}

}  // namespace

Turn turn_from_degrees(double degrees) {
  const double within = std::remainder(degrees, 360.0);
  const double quarters = within / 90.0;
  if (quarters == std::nearbyint(quarters)) {
    const int quarter = static_cast<int>(quarters);  // -2 .. 2
    return {quarter == 0 ? 1.0 : quarter % 2 == 0 ? -1.0 : 0.0, static_cast<double>(quarter % 2)};
  }
  return {std::cos(within / kDegreesPerRadian), std::sin(within / kDegreesPerRadian)};
}

void Coordinates::select(std::size_t system) {
  if (system == system_) {
    return;
  }
  system_ = system;
  chosen_ = work(system);
  refresh();
}

const WorkOffset& Coordinates::work(std::size_t system) const {
  static constexpr WorkOffset kNever{};
  if (system < kSystems) {
    return work_[system];
  }
  const std::size_t extended = system - kSystems;
  return extended < extended_.size() ? extended_[extended] : kNever;
}

void Coordinates::store_work(std::size_t system, const WorkOffset& offset) {
  if (system < kSystems) {
    work_[system] = offset;
    return;
  }
  const std::size_t extended = system - kSystems;
  if (extended >= extended_.size()) {
    extended_.resize(extended + 1);
  }
  extended_[extended] = offset;
}

void Coordinates::set_work(std::size_t system, const WorkOffset& offset) {
  store_work(system, offset);
  if (system == system_) {
    chosen_ = offset;
    refresh();
  }
}

void Coordinates::set_local(const Point& local_mm, const AuxiliaryWords& auxiliary_deg_mm) {
  local_mm_ = local_mm;
  local_auxiliary_deg_mm_ = auxiliary_deg_mm;
  refresh();
}

void Coordinates::set_tool(const Point& tool_mm) {
  tool_mm_ = tool_mm;
  refresh();
}

void Coordinates::set_scaling(const Scaling& scaling) {
  scaling_ = scaling;
  refresh();
}

void Coordinates::set_program_turn(const ProgramTurn& turn) {
  turn_ = turn;
  refresh();
}

void Coordinates::set_mirror(const Mirror& mirror) {
  mirror_ = mirror;
  refresh();
}

void Coordinates::refresh() {
  const Turn work = turn_from_degrees(chosen_.rotation_deg);
  const Turn turn68 = turn_from_degrees(turn_.angle_deg);
  Point sign{1.0, 1.0, 1.0};
  Point mirrored{};  // where the mirror has the program's origin
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (mirror_.mirrored[axis]) {
      sign[axis] = -1.0;
      mirrored[axis] = 2.0 * mirror_.about_mm[axis];
    }
  }
  // A turn seen in a mirror is the opposite one.
  const Turn both = turn_from_degrees(chosen_.rotation_deg + sign[0] * sign[1] * turn_.angle_deg);
  const Point k = product(sign, scaling_.factor);
  x_from_x_ = both.cosine * k[0];
  x_from_y_ = -both.sine * k[1];
  y_from_x_ = both.sine * k[0];
  y_from_y_ = both.cosine * k[1];
  z_from_z_ = k[2];

  const Point& about = scaling_.centre_mm;
  const Point& factor = scaling_.factor;
  const Point kept{(1.0 - factor[0]) * about[0], (1.0 - factor[1]) * about[1],
                   (1.0 - factor[2]) * about[2]};
  const Point moved = difference(turn_.centre_mm, turned_by(turn68, turn_.centre_mm));
  const Point inside = sum(turned_by(turn68, kept), moved);
  const Point before_turn = sum(sum(product(sign, inside), mirrored), local_mm_);
  shift_mm_ = sum(sum(turned_by(work, before_turn), chosen_.origin_mm), tool_mm_);
  plain_ =
      !turned() && x_from_x_ == 1.0 && y_from_y_ == 1.0 && z_from_z_ == 1.0 && shift_mm_ == Point{};
}

Point Coordinates::turned_to_machine(const Point& distance_mm) const {
  return {x_from_x_ * distance_mm[0] + x_from_y_ * distance_mm[1],
          y_from_x_ * distance_mm[0] + y_from_y_ * distance_mm[1], z_from_z_ * distance_mm[2]};
}

Point Coordinates::to_machine(const Point& program_mm) const {
  return sum(turned_to_machine(program_mm), shift_mm_);
}

Coordinates::ProgramX Coordinates::program_x() const {
  const double area = x_from_x_ * y_from_y_ - x_from_y_ * y_from_x_;
  return {y_from_y_ / area, -x_from_y_ / area, to_program({})[0]};
}

Point Coordinates::to_program(const Point& machine_mm) const {
  const Point d = difference(machine_mm, shift_mm_);
  const double area = x_from_x_ * y_from_y_ - x_from_y_ * y_from_x_;
  return {(y_from_y_ * d[0] - x_from_y_ * d[1]) / area,
          (x_from_x_ * d[1] - y_from_x_ * d[0]) / area, d[2] / z_from_z_};
}

AuxiliaryWords Coordinates::auxiliary_to_machine(const AuxiliaryWords& program_deg_mm) const {
  AuxiliaryWords machine;
  for (std::size_t k = 0; k < kAuxiliaryAxes; ++k) {
    machine[k] = program_deg_mm[k] + (local_auxiliary_deg_mm_[k] + chosen_.extra_deg_mm[k]);
  }
  return machine;
}

AuxiliaryWords Coordinates::auxiliary_to_program(const AuxiliaryWords& machine_deg_mm) const {
  AuxiliaryWords program;
  for (std::size_t k = 0; k < kAuxiliaryAxes; ++k) {
    program[k] = machine_deg_mm[k] - (local_auxiliary_deg_mm_[k] + chosen_.extra_deg_mm[k]);
  }
  return program;
}

}  // namespace kerf::parser
