#include "programs/kerf/page/code_runs.hpp"

namespace kerf::program {

void CodeRuns::add(std::int64_t tick, std::string_view codes) {
  if (codes == last_ || runs_.size() > kMaxRuns) {
    return;
  }
  last_ = codes;
  // The last run says that nothing is known any more.
  const std::string_view known = runs_.size() == kMaxRuns ? std::string_view() : codes;
  auto place = places_.find(known);
  if (place == places_.end()) {
    place = places_.emplace(known, static_cast<std::uint32_t>(texts_.size())).first;
    texts_.emplace_back(known);
  }
  runs_.push_back({.tick = tick, .codes = place->second});
}

}  // namespace kerf::program
