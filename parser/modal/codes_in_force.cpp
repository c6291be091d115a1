#include "parser/modal/codes_in_force.hpp"

#include <array>

#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

std::string tenths_code(int tenths) {
  return "G" + shortest(static_cast<double>(tenths) / 10.0);
}

// In the order of the enumerations.
constexpr std::array kPlaneCodes{"G17", "G18", "G19"};
constexpr std::array kFeedCodes{"G94", "G93", "G95"};
constexpr std::array kPathCodes{"G61", "G61.1", "G64"};
constexpr std::array kSpindleCodes{"M5", "M3", "M4"};

template <class Names, class Value>
const char* code_of(const Names& names, Value value) {
  return names[static_cast<std::size_t>(value)];
}

std::string work_code(std::size_t system) {
  if (system >= Coordinates::kSystems) {
    return "G54.1 P" + std::to_string(system - Coordinates::kSystems + 1);
  }
  constexpr std::size_t kWhole = 6;  // G54 to G59, then G59.1 to G59.3
  return system < kWhole ? "G" + std::to_string(54 + system)
                         : "G59." + std::to_string(system - kWhole + 1);
}

void add_overrides(const AllowedOverrides& overrides, std::vector<std::string>& codes) {
  if (!overrides.feed) {
    codes.emplace_back("M50 P0");
  }
  if (!overrides.speed) {
    codes.emplace_back("M51 P0");
  }
  if (overrides.adaptive_feed) {
    codes.emplace_back("M52");
  }
  if (!overrides.feed_hold) {
    codes.emplace_back("M53 P0");
  }
}

}  // namespace

std::vector<std::string> codes_in_force(const ModalState& state) {
  std::vector<std::string> codes = {
      tenths_code(static_cast<int>(state.motion)), code_of(kPlaneCodes, state.plane),
      state.units == Units::mm ? "G21" : "G20",    state.incremental ? "G91" : "G90",
      state.absolute_centre ? "G90.1" : "G91.1",   code_of(kFeedCodes, state.feed_mode),
      tenths_code(state.cutter_compensation),      state.tool_length_active ? "G43" : "G49",
      work_code(state.coordinates.system()),       code_of(kPathCodes, state.path_mode),
      state.to_initial_level ? "G98" : "G99",      state.surface_speed.active ? "G96" : "G97",
      code_of(kSpindleCodes, state.spindle),
  };
  const Coordinates& coordinates = state.coordinates;
  if (coordinates.mirror() != Mirror{}) {
    codes.emplace_back("G51.1");
  }
  if (coordinates.scaling() != Scaling{}) {
    codes.emplace_back("G51");
  }
  if (coordinates.program_turn() != ProgramTurn{}) {
    codes.emplace_back("G68");
  }
  add_overrides(state.overrides, codes);
  if (!state.mist && !state.flood) {
    codes.emplace_back("M9");
  }
  if (state.mist) {
    codes.emplace_back("M7");
  }
  if (state.flood) {
    codes.emplace_back("M8");
  }
  return codes;
}

std::string words_in_force(const ModalState& state) {
  const std::string feed = state.feed_word == 0.0 ? "" : "F" + shortest(state.feed_word) + " ";
  return feed + "S" + shortest(state.spindle_speed) + " T" + std::to_string(state.loaded_tool);
}

}  // namespace kerf::parser
