#include "parser/moves/auxiliary_axes.hpp"

#include <cmath>

namespace kerf::parser {

namespace {

// Of three axes, from `first` on.
double length_of(const AuxiliaryMove& way, std::size_t first) {
  return std::hypot(way.end_rad_mm[first] - way.begin_rad_mm[first],
                    way.end_rad_mm[first + 1] - way.begin_rad_mm[first + 1],
                    way.end_rad_mm[first + 2] - way.begin_rad_mm[first + 2]);
}

}  // namespace

bool AuxiliaryMove::only_turns() const {
  return length_of(*this, 3) < kShortestWay_mm;
}

double AuxiliaryMove::length_rad_mm() const {
  return length_of(*this, only_turns() ? 0 : 3);
}

AuxiliaryWords words_of(const AuxiliaryPosition& rad_mm) {
  AuxiliaryWords words = rad_mm;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    words[axis] /= kRadiansPerDegree;
  }
  return words;
}

AuxiliaryMove auxiliary_move(const AuxiliaryWords& begin_deg_mm, const AuxiliaryWords& end_deg_mm) {
  AuxiliaryMove way{begin_deg_mm, end_deg_mm};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    way.begin_rad_mm[axis] *= kRadiansPerDegree;
    way.end_rad_mm[axis] *= kRadiansPerDegree;
  }
  return way;
}

}  // namespace kerf::parser
