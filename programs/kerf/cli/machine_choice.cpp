#include "programs/kerf/cli/machine_choice.hpp"

#include <array>
#include <cerrno>
#include <filesystem>

#include <kerf/machine.hpp>
#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include "parser/modal/tool_table.hpp"
#include "programs/kerf/io/checksum.hpp"
#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20U;
constexpr std::size_t kMaxMachineMiB = 1;
constexpr std::size_t kMaxToolsMiB = 16;
constexpr std::size_t kMaxSurfaceMiB = 128;  // 1000 x 1000 points take some 30

// Of a longer file a little more than that. Error: why it cannot be read.
tl::expected<std::string, std::string> read_text(const std::string& path, std::size_t max_mib) {
  const auto file = open_regular(path);
  if (!file) {
    return tl::unexpected(file.error());
  }
  std::string text;
  std::array<char, 16'384> buffer{};
  while (text.size() <= max_mib * kMiB) {
    const ssize_t count = ::read(file->number(), buffer.data(), buffer.size());
    if (count == 0) {
      break;
    }
    if (count > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return tl::unexpected(error_text(errno));
    }
  }
  return text;
}

tl::unexpected<MachineRefusal> unreadable(const std::string& path, const std::string& why) {
  return tl::unexpected(
      MachineRefusal{.status = ExitStatus::io_error, .messages = {path + ": error: " + why}});
}

// A whole file that a machine file names.
tl::expected<std::string, MachineRefusal> read_part(const std::string& path, std::size_t max_mib) {
  auto text = read_text(path, max_mib);
  if (!text) {
    return unreadable(path, text.error());
  }
  if (text->size() > max_mib * kMiB) {
    return tl::unexpected(
        MachineRefusal{.messages = {fmt::format("{}: error: larger than {} MiB", path, max_mib)}});
  }
  return *std::move(text);
}

tl::expected<ChosenMachine, MachineRefusal> read_machine(const std::string& path,
                                                         Checksum& checksum) {
  // Its parser says that one is too long.
  const auto text = read_text(path, kMaxMachineMiB);
  if (!text) {
    return unreadable(path, text.error());
  }
  checksum.add(*text);
  auto settings = parse_machine_file(*text);
  if (settings) {
    return ChosenMachine{.settings = *std::move(settings), .driver = driver_of_machine_file(*text)};
  }
  MachineRefusal refusal;
  for (const SettingsError& error : settings.error()) {
    refusal.messages.push_back(to_string(error, path));
  }
  return tl::unexpected(refusal);
}

tl::expected<parser::ToolTable, MachineRefusal> read_tools(const std::string& path,
                                                           Checksum& checksum) {
  const auto text = read_part(path, kMaxToolsMiB);
  if (!text) {
    return tl::unexpected(text.error());
  }
  checksum.add("\ntools\n");
  checksum.add(*text);
  auto table = parser::read_tool_table(*text);
  if (table) {
    return *std::move(table);
  }
  MachineRefusal refusal;
  for (const parser::ToolTableError& error : table.error()) {
    refusal.messages.push_back(path + ":" + std::to_string(error.line) + ":" +
                               std::to_string(error.column) + ": error: " + error.message);
  }
  return tl::unexpected(refusal);
}

tl::expected<HeightMap, MachineRefusal> read_surface(const std::string& path, Checksum& checksum) {
  const auto text = read_part(path, kMaxSurfaceMiB);
  if (!text) {
    return tl::unexpected(text.error());
  }
  checksum.add("\nheight map\n");
  checksum.add(*text);
  auto map = read_height_map(*text);
  if (map) {
    return *std::move(map);
  }
  MachineRefusal refusal;
  refusal.messages.push_back(path + ":" + std::to_string(map.error().line) +
                             ": error: " + std::string(map.error().message));
  return tl::unexpected(refusal);
}

}  // namespace

tl::expected<ChosenMachine, MachineRefusal> choose_machine(const MachineOrder& order,
                                                           std::vector<std::string>& named) {
  ChosenMachine machine{.settings = default_machine()};
  Checksum checksum;
  if (order.file) {
    auto read = read_machine(*order.file, checksum);
    if (!read) {
      return tl::unexpected(read.error());
    }
    machine = *std::move(read);
  }
  MachineSettings& settings = machine.settings;
  const auto beside = [&](const std::string& name) {
    named.push_back(std::filesystem::path(*order.file).replace_filename(name).string());
    return named.back();
  };
  const std::string listed = settings.tool_file.empty() ? "" : beside(settings.tool_file);
  const std::string surface =
      settings.height_map_file.empty() ? "" : beside(settings.height_map_file);
  const std::string tools = order.tools.value_or(listed);
  if (!tools.empty()) {
    auto table = read_tools(tools, checksum);
    if (!table) {
      return tl::unexpected(table.error());
    }
    settings.program.tools = *std::move(table);
  }
  if (!surface.empty()) {
    auto map = read_surface(surface, checksum);
    if (!map) {
      return tl::unexpected(map.error());
    }
    settings.simulation.surface = *std::move(map);
  }
  if (order.g54_mm) {
    settings.program.work[0].origin_mm = *order.g54_mm;
    checksum.add(fmt::format("\nG54 {}", fmt::join(*order.g54_mm, " ")));
  }
  machine.checksum = checksum.value();
  return machine;
}

tl::expected<std::vector<NamedMachine>, MachineRefusal> choose_machines(
    const Options& options, std::vector<std::string>& named) {
  std::vector<std::optional<std::string>> files(options.machine_files.begin(),
                                                options.machine_files.end());
  if (files.empty()) {
    files.push_back(options.machine_file);
  }
  std::vector<NamedMachine> machines;
  for (const auto& file : files) {
    auto chosen =
        choose_machine({.file = file, .tools = options.tool_file, .g54_mm = options.g54_mm}, named);
    if (!chosen) {
      return tl::unexpected(chosen.error());
    }
    machines.push_back({.file = file, .chosen = *std::move(chosen)});
  }
  return machines;
}

Options options_on(const NamedMachine& machine, const Options& options) {
  Options result = options;
  result.machine_file = machine.file;
  result.driver = machine.chosen.driver;
  result.machine_checksum = machine.chosen.checksum;
  if (!options.driver_name.empty()) {
    result.driver.name = options.driver_name;
  }
  return result;
}

}  // namespace kerf::program
