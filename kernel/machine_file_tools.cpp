// [offsets.*] and [tools] of a machine file.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "kernel/machine_file_reader.hpp"
#include "parser/modal/tool_table.hpp"

namespace kerf {

void MachineFileReader::read_offsets(const Section& offsets) {
  const auto names = offset_sections();
  check_keys(offsets, names);
  for (std::size_t at = 0; at < names.size(); ++at) {
    if (const auto section = subsection(offsets, names[at])) {
      read_numbers(*section, offset_rules(at), at);
      check_offset_axes(*section, offset_rules(at).subspan(3, kAuxiliaryAxes));
    }
  }
}

// Either a file with the tools or the tools themselves.
void MachineFileReader::read_tools(const Section& tools) {
  constexpr std::array<std::string_view, 2> kKeys{"file", "tool"};
  check_keys(tools, kKeys);
  settings_.program.tools = {};
  settings_.program.tools.set_given();
  const toml::node* file = tools.table->get("file");
  const toml::node* list = tools.table->get("tool");
  if (file != nullptr && list != nullptr) {
    report(file->source(), "tools: found a file and tools, expected one of them");
  } else if (file != nullptr) {
    read_tool_file(*file);
  } else if (list != nullptr) {
    read_tool_list(*list);
  }
}

void MachineFileReader::read_tool_file(const toml::node& file) {
  if (const auto* name = file.as_string(); name != nullptr && !name->get().empty()) {
    settings_.tool_file = name->get();
    return;
  }
  report(file.source(), "tools.file: found " +
                            std::string(file.is_string() ? "nothing" : name_of(file.type())) +
                            ", expected the name of a file");
}

void MachineFileReader::read_tool_list(const toml::node& list) {
  if (!list.is_array()) {
    report(list.source(), "tools.tool: found " + std::string(name_of(list.type())) +
                              ", expected an array of tables ([[tools.tool]])");
    return;
  }
  for (const toml::node& item : *list.as_array()) {
    if (const toml::table* table = item.as_table()) {
      read_tool({table, "tools.tool"});
    } else {
      report(item.source(),
             "tools.tool: found " + std::string(name_of(item.type())) + ", expected a table");
    }
  }
}

void MachineFileReader::read_tool(const Section& section) {
  std::vector<std::string_view> keys;
  std::array<double, 6> values{};
  for (std::size_t at = 0; at < values.size(); ++at) {
    const NumberRule& rule = tool_rules()[at];
    keys.push_back(rule.key);
    if (const toml::node* node = section.table->get(rule.key)) {
      values[at] = read_number(section, rule, *node).value_or(0.0);
    }
  }
  check_keys(section, keys);
  if (const toml::node* pocket = section.table->get("pocket");
      pocket != nullptr && values[1] != std::floor(values[1])) {
    report(pocket->source(), "tools.tool.pocket: expected the pocket's number, a whole one");
    return;
  }
  const auto number = static_cast<std::int32_t>(values[0]);
  const toml::node* named = section.table->get("number");
  if (named == nullptr || static_cast<double>(number) != values[0]) {
    report(named != nullptr ? named->source() : section.table->source(),
           "tools.tool.number: expected the tool's number, a whole one");
    return;
  }
  parser::ToolTable& tools = settings_.program.tools;
  const auto& listed = tools.listed();
  if (std::any_of(listed.begin(), listed.end(),
                  [&](const parser::Tool& tool) { return tool.number == number; })) {
    report(named->source(), "tools.tool: T" + std::to_string(number) + " is listed twice");
  }
  const bool has_pocket = section.table->contains("pocket");
  tools.put({.number = number,
             .pocket = has_pocket ? static_cast<std::int32_t>(values[1]) : number,
             .offset_mm = {values[3], values[4], values[5]},
             .diameter_mm = values[2]});
}

}  // namespace kerf
