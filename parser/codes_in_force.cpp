#include "parser/codes_in_force.hpp"

#include "parser/text.hpp"

namespace kerf::parser {

namespace {

std::string motion_code(Motion motion) {
  return "G" + shortest(static_cast<double>(motion) / 10.0);
}

const char* plane_code(Plane plane) {
  return plane == Plane::xy ? "G17" : plane == Plane::zx ? "G18" : "G19";
}

const char* path_code(PathMode mode) {
  return mode == PathMode::blend ? "G64" : mode == PathMode::exact_stop ? "G61.1" : "G61";
}

const char* spindle_code(Spindle spindle) {
  return spindle == Spindle::off ? "M5" : spindle == Spindle::clockwise ? "M3" : "M4";
}

}  // namespace

std::vector<std::string> codes_in_force(const ModalState& state) {
  return {
      motion_code(state.motion),
      plane_code(state.plane),
      state.units == Units::mm ? "G21" : "G20",
      state.incremental ? "G91" : "G90",
      state.absolute_centre ? "G90.1" : "G91.1",
      state.feed_mode == FeedMode::per_minute ? "G94" : "G93",
      path_code(state.path_mode),
      spindle_code(state.spindle),
  };
}

}  // namespace kerf::parser
