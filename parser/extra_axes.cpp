#include "parser/extra_axes.hpp"

#include <cmath>

namespace kerf::parser {

double extra_word_deg_mm(const Block& block, std::size_t extra_axis, Units units) {
  return block.value(kExtraNames[extra_axis]) * (turns(extra_axis) ? 1.0 : mm_per_unit(units));
}

bool ExtraWay::only_turns() const {
  return begin_rad_mm[3] == end_rad_mm[3] && begin_rad_mm[4] == end_rad_mm[4] &&
         begin_rad_mm[5] == end_rad_mm[5];
}

double ExtraWay::length_rad_mm() const {
  const std::size_t first = only_turns() ? 0 : 3;
  return std::hypot(end_rad_mm[first] - begin_rad_mm[first],
                    end_rad_mm[first + 1] - begin_rad_mm[first + 1],
                    end_rad_mm[first + 2] - begin_rad_mm[first + 2]);
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
