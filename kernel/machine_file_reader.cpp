#include "kernel/machine_file_reader.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "kernel/machine_file_checks.hpp"
#include "kernel/machine_file_text.hpp"

namespace kerf {

namespace {

constexpr std::array<std::string_view, 11> kSections{"tick",   "path",   "axes",      "offsets",
                                                     "tools",  "probe",  "program",   "inputs",
                                                     "manual", "driver", "simulation"};
constexpr std::array<std::string_view, 9> kAllAxisNames{"x", "y", "z", "a", "b",
                                                        "c", "u", "v", "w"};
constexpr auto kAxisNames = std::span(kAllAxisNames).first<3>();
constexpr auto kExtraAxisNames = std::span(kAllAxisNames).last<6>();

// A key counts even where its value is wrong, and a section that is no table might have had it:
// both have their own error.
bool may_have(const Section& file, std::string_view section, const BoundRule& rule) {
  const toml::node_view node = file.table->at_path(section);
  return node && (!node.is_table() || node.as_table()->contains(rule.key));
}

// The axes whose section lacks the bound, "axes.x, axes.z"; none where [path] has it.
std::string axes_without(const Section& file, const BoundRule& rule) {
  if (may_have(file, "path", rule)) {
    return "";
  }
  std::string missing;
  for (const std::string_view axis : kAxisNames) {
    const std::string section = "axes." + std::string(axis);
    if (!may_have(file, section, rule)) {
      missing += (missing.empty() ? "" : ", ") + section;
    }
  }
  return missing;
}

}  // namespace

std::string_view name_of(toml::node_type type) {
  switch (type) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    case toml::node_type::date:
    case toml::node_type::time:
    case toml::node_type::date_time:
      return "a date or time";
    case toml::node_type::none:
      break;
  }
  return "nothing";
}

tl::expected<MachineSettings, std::vector<SettingsError>> MachineFileReader::read(
    const toml::table& root) {
  const Section file{&root, ""};
  check_keys(file, kSections);
  if (const auto tick = subsection(file, "tick")) {
    read_numbers(*tick, tick_rules(), 0);
  }
  if (const auto path = subsection(file, "path")) {
    read_numbers(*path, path_rules(), 0);
  }
  read_axes(file);
  if (const auto offsets = subsection(file, "offsets")) {
    read_offsets(*offsets);
  }
  if (const auto tools = subsection(file, "tools")) {
    read_tools(*tools);
  }
  if (const auto probe = subsection(file, "probe")) {
    read_probe(*probe);
  }
  settings_.program.path_control = {.mode = PathMode::blend,
                                    .corner_tolerance_mm = settings_.program.corner_tolerance_mm,
                                    .merge_tolerance_mm = settings_.program.merge_tolerance_mm};
  if (const auto program = subsection(file, "program")) {
    read_program(*program);
  }
  if (const auto inputs = subsection(file, "inputs")) {
    read_inputs(*inputs);
  }
  if (const auto manual = subsection(file, "manual")) {
    read_manual(*manual);
  }
  if (const auto simulation = subsection(file, "simulation")) {
    read_simulation(*simulation);
  }
  if (const auto driver = subsection(file, "driver")) {
    read_driver(*driver);
  }
  check_bounds(file);
  settings_.table.period_s = settings_.limits.period_s;
  if (errors_.empty()) {
    return settings_;
  }
  std::stable_sort(errors_.begin(), errors_.end(), [](const auto& a, const auto& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  return tl::unexpected(std::move(errors_));
}

void MachineFileReader::read_axes(const Section& file) {
  const auto axes = subsection(file, "axes");
  if (axes) {
    check_keys(*axes, kAllAxisNames);
  }
  const auto section_of = [&](std::string_view name) {
    return axes ? subsection(*axes, name) : std::nullopt;
  };
  for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
    if (const auto section = section_of(kAxisNames[axis])) {
      read_axis(*section, axis);
    } else {
      raise_silent_drive(settings_, axis, [](std::string_view) { return false; });
    }
  }
  for (std::size_t axis = 0; axis < kExtraAxisNames.size(); ++axis) {
    if (const auto section = section_of(kExtraAxisNames[axis])) {
      read_extra_axis(*section, axis);
    }
  }
}

void MachineFileReader::report(const toml::source_region& where, std::string message) {
  errors_.push_back({where.begin.line, where.begin.column, std::move(message)});
}

void MachineFileReader::check_keys(const Section& section,
                                   std::span<const std::string_view> known) {
  for (const auto& [key, value] : *section.table) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) {
      continue;
    }
    std::string message = "unknown key " + in_quotes(key.str());
    message += section.name.empty() ? "" : " in [" + section.name + "]";
    if (const auto meant = nearest_word(key.str(), known)) {
      message += ", did you mean '" + std::string(*meant) + "'?";
    }
    report(key.source(), std::move(message));
  }
}

std::optional<Section> MachineFileReader::subsection(const Section& section, std::string_view key) {
  const toml::node* node = section.table->get(key);
  if (node == nullptr) {
    return std::nullopt;
  }
  if (const toml::table* table = node->as_table()) {
    return Section{table, section.path_to(key)};
  }
  report(node->source(), section.path_to(key) + ": found " + std::string(name_of(node->type())) +
                             ", expected a table");
  return std::nullopt;
}

void MachineFileReader::read_numbers(const Section& section, std::span<const NumberRule> rules,
                                     std::size_t axis) {
  std::vector<std::string_view> keys;
  for (const NumberRule& rule : rules) {
    keys.push_back(rule.key);
    if (const toml::node* node = section.table->get(rule.key)) {
      if (const auto number = read_number(section, rule, *node)) {
        rule.field(settings_, axis) = *number * rule.factor;
      }
    }
  }
  check_keys(section, keys);
}

std::optional<double> MachineFileReader::read_number(const Section& section, const NumberRule& rule,
                                                     const toml::node& node) {
  double number = 0.0;
  if (const auto* integer = node.as_integer()) {
    number = static_cast<double>(integer->get());
  } else if (const auto* floating = node.as_floating_point()) {
    number = floating->get();
  } else {
    report(node.source(), section.path_to(rule.key) + ": found " +
                              std::string(name_of(node.type())) + ", expected a number");
    return std::nullopt;
  }
  if (const auto problem = range_problem(rule, number)) {
    report(node.source(), section.path_to(rule.key) + ": " + *problem);
    return std::nullopt;
  }
  return number;
}

void MachineFileReader::read_truth(const Section& section, std::string_view key, bool& truth) {
  const toml::node* const node = section.table->get(key);
  if (node != nullptr && node->is_boolean()) {
    truth = node->as_boolean()->get();
  } else if (node != nullptr) {
    report(node->source(), section.path_to(key) + ": found " + std::string(name_of(node->type())) +
                               ", expected true or false");
  }
}

void MachineFileReader::read_axis(const Section& section, std::size_t axis) {
  const std::size_t errors_before = errors_.size();
  read_numbers(section, axis_rules(), axis);
  if (errors_.size() > errors_before) {
    return;
  }
  const std::string_view upper = axis_rules()[1].key;
  if (const auto problem = travel_problem(axis_rules(), settings_, axis);
      problem && section.table->contains(upper)) {
    report(section.table->get(upper)->source(), section.path_to(upper) + ": " + *problem);
  }
  const auto has_key = [&](std::string_view key) { return section.table->contains(key); };
  raise_silent_drive(settings_, axis, has_key);
  for (const KeyProblem& problem : check_axis(settings_, axis, has_key)) {
    report(section.table->get(problem.key)->source(),
           section.path_to(problem.key) + ": " + problem.message);
  }
}

void MachineFileReader::check_bounds(const Section& file) {
  for (const BoundRule& rule : bound_rules()) {
    const std::string missing = axes_without(file, rule);
    if (!missing.empty()) {
      const auto path = file.table->find("path");
      report(path != file.table->end() ? path->first.source() : toml::source_region{},
             "nothing bounds the " + std::string(rule.quantity) + ": expected " +
                 std::string(rule.key) + " in [path] or in every axis (missing in " + missing +
                 ")");
    }
  }
}

}  // namespace kerf
