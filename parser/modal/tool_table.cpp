#include "parser/modal/tool_table.hpp"

#include <algorithm>

namespace kerf {
inline namespace v0 {

namespace {

auto place_of(const std::vector<Tool>& tools, std::int32_t number) {
  return std::lower_bound(tools.begin(), tools.end(), number,
                          [](const Tool& tool, std::int32_t n) { return tool.number < n; });
}

}  // namespace

const Tool* ToolTable::find(std::int32_t number) const {
  static constexpr Tool kPlain{};
  const auto at = place_of(tools_, number);
  if (at != tools_.end() && at->number == number) {
    return &*at;
  }
  return number == 0 || !given_ ? &kPlain : nullptr;
}

void ToolTable::put(const Tool& tool) {
  const auto at = place_of(tools_, tool.number);
  const auto index = at - tools_.begin();
  if (at != tools_.end() && at->number == tool.number) {
    tools_[static_cast<std::size_t>(index)] = tool;
  } else {
    tools_.insert(at, tool);
  }
}

}  // namespace v0
}  // namespace kerf
