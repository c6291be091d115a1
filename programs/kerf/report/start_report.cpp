#include "programs/kerf/report/start_report.hpp"

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/visible_text.hpp"

namespace kerf::program {

std::string name_of(const LineRound& place) {
  std::string text = fmt::format("line {}", place.line);
  if (place.round > 1) {
    text += fmt::format(":{}", place.round);
  }
  if (!place.file.empty()) {
    text += " of " + visible(place.file);
  }
  return text;
}

}  // namespace kerf::program
