#include "programs/kerf/io/machine_lock.hpp"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <spdlog/fmt/fmt.h>

namespace kerf::program {

namespace {

constexpr const char* kTaken = "another kerf run has this machine";

// A socket of a name that is in no folder: nobody else can bind one of the same name, and it ends
// with its process.
tl::expected<Descriptor, std::string> lock_name(const std::string& machine_file) {
  std::error_code none;  // a file that is open has a path
  const std::string path = std::filesystem::canonical(machine_file, none).string();
  const std::string name = fmt::format("kerf-{:016x}", std::hash<std::string>{}(path));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::ranges::copy(name, std::span(address.sun_path).subspan(1).begin());  // after a zero
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (!socket.is_open() ||
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): as bind() is called
      ::bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), size) != 0) {
    return tl::unexpected(errno == EADDRINUSE ? kTaken : "cannot be locked: " + error_text(errno));
  }
  return socket;
}

tl::expected<Descriptor, std::string> lock_file(const std::string& machine_file) {
  auto file = open_regular(machine_file);
  if (file && ::flock(file->number(), LOCK_EX | LOCK_NB) != 0) {
    return tl::unexpected(errno == EWOULDBLOCK ? kTaken : "cannot be locked: " + error_text(errno));
  }
  return file;
}

}  // namespace

tl::expected<MachineLock, std::string> lock_machine(const std::string& machine_file) {
  auto file = lock_file(machine_file);
  auto name = file ? lock_name(machine_file) : tl::unexpected(file.error());
  if (!name) {
    return tl::unexpected(machine_file + ": " + name.error());
  }
  return MachineLock{.file = *std::move(file), .name = *std::move(name)};
}

}  // namespace kerf::program
