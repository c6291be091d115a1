#include "programs/kerf/io/descriptor.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>

#include "programs/kerf/io/interrupt.hpp"

namespace kerf::program {

namespace {

// What a pipe that is ready takes without waiting.
constexpr std::size_t kRoom = 4096;

// False: there is none, and a stop is requested. Asked again and again, for the request may come
// just before the wait.
bool wait_for_room(int descriptor) noexcept {
  constexpr int kPatienceMs = 100;
  pollfd waiting{.fd = descriptor, .events = POLLOUT, .revents = 0};
  while (::poll(&waiting, 1, kPatienceMs) <= 0) {
    if (stop_requested()) {
      return false;
    }
  }
  return true;
}

const char* kind_of(mode_t mode) noexcept {
  return S_ISFIFO(mode) ? "FIFO" : S_ISSOCK(mode) ? "socket" : "device";
}

}  // namespace

int Descriptor::close() noexcept {
  if (!is_open()) {
    return 0;
  }
  return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno;
}

int write_all(int descriptor, std::string_view bytes) noexcept {
  struct stat about {};
  const bool may_stall = ::fstat(descriptor, &about) == 0 && !S_ISREG(about.st_mode);
  while (!bytes.empty()) {
    if (may_stall && !wait_for_room(descriptor)) {
      return EINTR;
    }
    const std::size_t most = may_stall ? kRoom : bytes.size();
    const ssize_t written = ::write(descriptor, bytes.data(), std::min(bytes.size(), most));
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR && errno != EAGAIN) {
      return errno;
    }
  }
  return 0;
}

tl::expected<Descriptor, std::string> open_regular(const std::string& path) {
  // Without O_NONBLOCK a FIFO would be waited for.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  struct stat about {};
  if (!file.is_open() || ::fstat(file.number(), &about) != 0) {
    return tl::unexpected(error_text(errno));
  }
  if (S_ISDIR(about.st_mode)) {
    return tl::unexpected(error_text(EISDIR));
  }
  if (!S_ISREG(about.st_mode)) {
    return tl::unexpected(std::string("is a ") + kind_of(about.st_mode) + ", not a regular file");
  }
  return file;
}

std::string error_text(int error_number) {
  const char* text = strerrordesc_np(error_number);
  return text != nullptr ? text : "error " + std::to_string(error_number);
}

}  // namespace kerf::program
