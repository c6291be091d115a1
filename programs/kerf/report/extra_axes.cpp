#include "programs/kerf/report/extra_axes.hpp"

namespace kerf::program {

std::vector<ExtraAxis> extra_axes(parser::Letters named) {
  constexpr std::string_view kNames = "abcuvw";
  constexpr double kDegreesPerRadian = 180.0 / 3.14159265358979323846;
  std::vector<ExtraAxis> axes;
  for (std::size_t k = 0; k < kAuxiliaryAxes; ++k) {
    if ((named & parser::letter_bit(parser::kAuxiliaryNames[k])) != 0) {
      const bool rotary = parser::is_rotary(k);
      axes.push_back({.index = k,
                      .name = kNames.substr(k, 1),
                      .unit = rotary ? "deg" : "mm",
                      .factor = rotary ? kDegreesPerRadian : 1.0});
    }
  }
  return axes;
}

}  // namespace kerf::program
