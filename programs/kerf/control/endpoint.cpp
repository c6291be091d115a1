#include "programs/kerf/control/endpoint.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

namespace kerf::program {

namespace {

tl::unexpected<std::string> failed(const std::string& named, const std::string& reason) {
  return tl::unexpected("--control " + named + ": " + reason);
}

// "3" or "4,5".
struct Numbers {
  int in = -1;
  int out = -1;
};
std::optional<Numbers> numbers_of(const std::string& named) {
  Numbers numbers;
  const char* const end = named.data() + named.size();
  const auto first = std::from_chars(named.data(), end, numbers.in);
  if (first.ec != std::errc() || numbers.in < 0) {
    return std::nullopt;
  }
  numbers.out = numbers.in;
  if (first.ptr == end) {
    return numbers;
  }
  const auto second = std::from_chars(first.ptr + 1, end, numbers.out);
  const bool two = *first.ptr == ',' && second.ec == std::errc() && second.ptr == end;
  return two && numbers.out >= 0 ? std::optional(numbers) : std::nullopt;
}

// 0, or the errno. A regular file cannot be waited for.
int check(int number) {
  struct stat about {};
  if (::fstat(number, &about) != 0) {
    return errno;
  }
  return S_ISREG(about.st_mode) || S_ISDIR(about.st_mode) ? EINVAL : 0;
}

tl::expected<ControlEndpoint, std::string> open_numbers(const std::string& named,
                                                        const Numbers& numbers) {
  for (const int number : {numbers.in, numbers.out}) {
    if (const int error = check(number); error != 0) {
      return failed(named, "descriptor " + std::to_string(number) + ": " + error_text(error));
    }
  }
  ControlEndpoint endpoint{.in = Descriptor(::fcntl(numbers.in, F_DUPFD_CLOEXEC, 3))};
  if (numbers.out != numbers.in) {
    endpoint.out = Descriptor(::fcntl(numbers.out, F_DUPFD_CLOEXEC, 3));
  }
  return endpoint;
}

// The address is that of a path, which the calls take as one of any family.
const sockaddr* generic(const sockaddr_un& address) {
  return reinterpret_cast<const sockaddr*>(&address);  // NOLINT(*-reinterpret-cast)
}

bool somebody_listens(const sockaddr_un& address) {
  const Descriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  return ::connect(probe.number(), generic(address), sizeof address) == 0 || errno != ECONNREFUSED;
}

int bind_privately(int socket, const sockaddr_un& address) {
  const mode_t before = ::umask(S_IXUSR | S_IRWXG | S_IRWXO);
  const int bound = ::bind(socket, generic(address), sizeof address) == 0 ? 0 : errno;
  ::umask(before);
  return bound;
}

tl::expected<ControlEndpoint, std::string> listen_at(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    return failed(path,
                  "is no path of 1 to " + std::to_string(sizeof address.sun_path - 1) + " bytes");
  }
  std::memcpy(static_cast<void*>(address.sun_path), path.data(), path.size());
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  int error = socket.is_open() ? bind_privately(socket.number(), address) : errno;
  struct stat about {};
  if (error == EADDRINUSE && ::lstat(path.c_str(), &about) == 0 && S_ISSOCK(about.st_mode) &&
      !somebody_listens(address) && ::unlink(path.c_str()) == 0) {
    error = bind_privately(socket.number(), address);
  }
  SocketFile file(error == 0 ? path : std::string());
  constexpr int kBacklog = 8;
  if (error == 0 && ::listen(socket.number(), kBacklog) != 0) {
    error = errno;
  }
  if (error != 0) {
    return failed(path, error_text(error));
  }
  return ControlEndpoint{.listens = std::move(socket), .file = std::move(file)};
}

}  // namespace

tl::expected<ControlEndpoint, std::string> open_control(const std::string& named) {
  const auto numbers = numbers_of(named);
  return numbers ? open_numbers(named, *numbers) : listen_at(named);
}

}  // namespace kerf::program
