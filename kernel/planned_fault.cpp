#include "kernel/planned_fault.hpp"

#include <algorithm>

#include "kernel/machine_file_text.hpp"

namespace kerf {

tl::expected<PlannedFault, std::string> planned_fault(const FaultWords& words) {
  const auto& [kind, axis] = words;
  const auto* const name = std::ranges::find(kTableFaultNames, kind);
  if (name == kTableFaultNames.end()) {
    const auto meant = nearest_word(kind, kTableFaultNames);
    return tl::unexpected("there is no fault " + in_quotes(kind) +
                          (meant ? ", did you mean " + in_quotes(*meant) + "?" : ""));
  }
  const auto what = static_cast<TableFault>(name - kTableFaultNames.begin());
  const bool has_axis = what < TableFault::emergency_loop;
  const auto letter =
      axis.size() == 1 ? std::string_view("xyz").find(axis) : std::string_view::npos;
  if (has_axis ? letter == std::string_view::npos : !axis.empty()) {
    return tl::unexpected(std::string(kind) +
                          (has_axis ? " is of an axis, 'x', 'y' or 'z'" : " is of no axis"));
  }
  return PlannedFault{.what = what,
                      .axis = static_cast<std::int8_t>(has_axis ? static_cast<int>(letter) : -1)};
}

}  // namespace kerf
