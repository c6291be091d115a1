#include "parser/offsets/coordinates.hpp"

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
  chosen_ = work_[system];
  refresh();
}

void Coordinates::set_work(std::size_t system, const WorkOffset& offset) {
  work_[system] = offset;
  if (system == system_) {
    chosen_ = offset;
    refresh();
  }
}

void Coordinates::set_local(const Point& local_mm) {
  local_mm_ = local_mm;
  refresh();
}

void Coordinates::set_tool(const Point& tool_mm) {
  tool_mm_ = tool_mm;
  refresh();
}

void Coordinates::refresh() {
  const Turn turn = turn_from_degrees(chosen_.rotation_deg);
  cosine_ = turn.cosine;
  sine_ = turn.sine;
  shift_mm_ = sum(sum(turned_by(turn, local_mm_), chosen_.origin_mm), tool_mm_);
  plain_ = !turned() && shift_mm_ == Point{};
}

Point Coordinates::to_machine(const Point& program_mm) const {
  return sum(turned_by({cosine_, sine_}, program_mm), shift_mm_);
}

Point Coordinates::to_program(const Point& machine_mm) const {
  return turned_by({cosine_, -sine_}, difference(machine_mm, shift_mm_));
}

Point Coordinates::turned_to_machine(const Point& distance_mm) const {
  return turned_by({cosine_, sine_}, distance_mm);
}

Point Coordinates::local_for(const Point& machine_mm, const Point& program_mm) const {
  const Point fixed = sum(chosen_.origin_mm, tool_mm_);
  return difference(turned_by({cosine_, -sine_}, difference(machine_mm, fixed)), program_mm);
}

}  // namespace kerf::parser
