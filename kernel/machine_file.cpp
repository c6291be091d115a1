#include <cstddef>
#include <utility>

#include <kerf/machine.hpp>

#include "kernel/machine_file_reader.hpp"

namespace kerf {
inline namespace v0 {
namespace {

constexpr std::size_t kLargestFileBytes = std::size_t{1} << 20;

}  // namespace

std::string to_string(const SettingsError& error, std::string_view file) {
  std::string text(file);
  if (error.line > 0) {
    text += ":" + std::to_string(error.line) + ":" + std::to_string(error.column);
  }
  return text + ": error: " + error.message;
}

tl::expected<MachineSettings, std::vector<SettingsError>> parse_machine_file(
    std::string_view toml) {
  if (toml.size() > kLargestFileBytes) {
    return tl::unexpected(std::vector{SettingsError{
        .message = "found " + std::to_string(toml.size()) + " bytes, expected at most 1 MiB"}});
  }
  const toml::parse_result parsed = toml::parse(toml);
  if (!parsed) {
    const toml::parse_error& error = parsed.error();
    const toml::source_position where = error.source().begin;
    return tl::unexpected(std::vector{SettingsError{
        .line = where.line, .column = where.column, .message = std::string(error.description())}});
  }
  return MachineFileReader().read(parsed.table());
}

}  // namespace v0
}  // namespace kerf
