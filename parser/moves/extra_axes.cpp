#include "parser/moves/extra_axes.hpp"

#include <cmath>

namespace kerf::parser {

namespace {

// Of three axes, from `first` on.
double length_of(const ExtraWay& way, std::size_t first) {
  return std::hypot(way.end_rad_mm[first] - way.begin_rad_mm[first],
                    way.end_rad_mm[first + 1] - way.begin_rad_mm[first + 1],
                    way.end_rad_mm[first + 2] - way.begin_rad_mm[first + 2]);
}

}  // namespace

bool ExtraWay::only_turns() const {
  return length_of(*this, 3) < kShortestWay_mm;
}

double ExtraWay::length_rad_mm() const {
  return length_of(*this, only_turns() ? 0 : 3);
}

ExtraWords words_of(const std::array<double, kExtraAxes>& rad_mm) {
  ExtraWords words = rad_mm;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    words[axis] /= kRadiansPerDegree;
  }
  return words;
}

ExtraWay extra_way(const ExtraWords& begin_deg_mm, const ExtraWords& end_deg_mm) {
  ExtraWay way{begin_deg_mm, end_deg_mm};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    way.begin_rad_mm[axis] *= kRadiansPerDegree;
    way.end_rad_mm[axis] *= kRadiansPerDegree;
  }
  return way;
}

}  // namespace kerf::parser
