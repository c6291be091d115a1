// Reads the tables of a machine file into settings. Internal to kernel/machine_file*.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <kerf/machine.hpp>

#include "kernel/driver_settings.hpp"
#include "kernel/machine_file_schema.hpp"

// Header-only, so that an error is a value: the packaged shared library is built with exceptions.
// NOLINTBEGIN(cppcoreguidelines-macro-usage): toml++ is configured by macros.
#undef TOML_HEADER_ONLY
#undef TOML_SHARED_LIB
#undef TOML_EXCEPTIONS
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
// NOLINTEND(cppcoreguidelines-macro-usage)
#include <toml++/toml.h>

namespace kerf {

// A table of the file under the name that messages give it: "" for the whole file, "axes.x".
struct Section {
  const toml::table* table;
  std::string name;

  [[nodiscard]] std::string path_to(std::string_view key) const {
    return name.empty() ? std::string(key) : name + "." + std::string(key);
  }
};

// What a value is, for messages: "a table".
std::string_view name_of(toml::node_type type);

class MachineFileReader {
 public:
  // All that the file says, or all that is wrong with it in the order of the text.
  tl::expected<MachineSettings, std::vector<SettingsError>> read(const toml::table& root);
  // What read() found under [driver].
  [[nodiscard]] const DriverSettings& driver() const noexcept { return driver_; }

 private:
  // machine_file_reader.cpp
  void report(const toml::source_region& where, std::string message);
  void check_keys(const Section& section, std::span<const std::string_view> known);
  std::optional<Section> subsection(const Section& section, std::string_view key);
  void read_numbers(const Section& section, std::span<const NumberRule> rules, std::size_t axis);
  std::optional<double> read_number(const Section& section, const NumberRule& rule,
                                    const toml::node& node);
  void read_truth(const Section& section, std::string_view key, bool& truth);
  void read_axes(const Section& file);
  void read_axis(const Section& section, std::size_t axis);
  void check_bounds(const Section& file);

  // machine_file_program.cpp
  void read_program(const Section& section);
  void read_dialect(const Section& section);
  void read_path_mode(const Section& section);
  void read_inputs(const Section& section);

  // machine_file_manual.cpp
  void read_manual(const Section& section);

  // machine_file_axes.cpp
  void read_extra_axis(const Section& section, std::size_t axis);
  void check_offset_axes(const Section& section, std::span<const NumberRule> extra_rules);

  // machine_file_tools.cpp
  void read_offsets(const Section& offsets);
  void read_tools(const Section& tools);
  void read_tool_file(const toml::node& file);
  void read_tool_list(const toml::node& list);
  void read_tool(const Section& section);

  // machine_file_simulation.cpp
  void read_probe(const Section& probe);
  void read_box(const Section& probe);
  bool read_plane(const Section& probe);  // false: there is none
  void read_simulation(const Section& section);
  void read_home_switch(const Section& section, std::size_t axis);
  // The numbers of an array, one after the other; false: something is wrong with it.
  bool read_array(const Section& section, std::string_view key, std::size_t most,
                  std::vector<double>& numbers);

  // machine_file_driver.cpp
  void read_driver(const Section& section);
  void read_max_late_periods(const Section& section);

  // machine_file_faults.cpp
  void read_faults(const Section& driver);
  void read_fault(const Section& section);

  MachineSettings settings_{};
  DriverSettings driver_{};
  std::vector<SettingsError> errors_;
};

}  // namespace kerf
