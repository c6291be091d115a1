#include "programs/machine_choice.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>

#include "kernel/machine_file.hpp"
#include "programs/descriptor.hpp"

namespace kerf::program {

namespace {

// One byte more than a machine file may have: the parser says that it is too long.
constexpr std::size_t kMostBytes = (std::size_t{1} << 20U) + 1;

tl::expected<std::string, int> read_text(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) {
    return tl::unexpected(errno);
  }
  std::string text;
  std::array<char, 16'384> buffer{};
  while (text.size() < kMostBytes) {
    const ssize_t count = ::read(file.number(), buffer.data(), buffer.size());
    if (count == 0) {
      break;
    }
    if (count > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return tl::unexpected(errno);
    }
  }
  return text;
}

}  // namespace

tl::expected<MachineSettings, MachineRefusal> choose_machine(
    const std::optional<std::string>& machine_file) {
  if (!machine_file) {
    return default_machine();
  }
  const auto text = read_text(*machine_file);
  if (!text) {
    return tl::unexpected(
        MachineRefusal{.status = ExitStatus::io_error,
                       .messages = {*machine_file + ": error: " + error_text(text.error())}});
  }
  const auto settings = parse_machine_file(*text);
  if (!settings) {
    MachineRefusal refusal;
    for (const SettingsError& error : settings.error()) {
      refusal.messages.push_back(to_string(error, *machine_file));
    }
    return tl::unexpected(refusal);
  }
  return *settings;
}

}  // namespace kerf::program
