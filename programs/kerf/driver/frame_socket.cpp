#include "programs/kerf/driver/frame_socket.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <poll.h>
#include <span>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>

#include <spdlog/fmt/fmt.h>

namespace kerf::program {

namespace {

constexpr const char* kHangsUp = "the machine hangs up";

// Whose queue is full does not answer, either.
tl::expected<Descriptor, int> connect_to(const std::string& path, double timeout_s) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    return tl::unexpected(ENAMETOOLONG);
  }
  std::memcpy(static_cast<void*>(address.sun_path), path.data(), path.size());
  Descriptor socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
  // The address is that of a path, which the call takes as one of any family.
  const auto* const any =
      reinterpret_cast<const sockaddr*>(&address);  // NOLINT(*-reinterpret-cast)
  const auto wait_for = [&socket](timeval time) {
    static_cast<void>(::setsockopt(socket.number(), SOL_SOCKET, SO_SNDTIMEO, &time, sizeof time));
  };
  wait_for({.tv_sec = static_cast<time_t>(std::ceil(timeout_s)), .tv_usec = 0});
  const auto is_connected = [&] {
    int result = -1;
    do {
      result = ::connect(socket.number(), any, sizeof address);
    } while (result != 0 && errno == EINTR);
    return result == 0;
  };
  if (!socket.is_open() || !is_connected()) {
    return tl::unexpected(errno == EAGAIN ? ETIMEDOUT : errno);
  }
  wait_for({});
  // As much as the system gives: the frames of a time-out and more wait for who is late.
  constexpr int kRoomBytes = 1 << 20;
  static_cast<void>(
      ::setsockopt(socket.number(), SOL_SOCKET, SO_SNDBUF, &kRoomBytes, sizeof kRoomBytes));
  return socket;
}

// A signal ends no wait.
bool has_input_within(double timeout_s, const Descriptor& socket) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::duration<double>(timeout_s);
  pollfd waits{.fd = socket.number(), .events = POLLIN, .revents = 0};
  int ready = -1;
  do {
    const std::chrono::duration<double, std::milli> left = until - Clock::now();
    ready = ::poll(&waits, 1, static_cast<int>(std::max(left.count(), 0.0)));
  } while (ready < 0 && errno == EINTR);
  return ready > 0;
}

}  // namespace

tl::expected<FrameSocket, std::string> FrameSocket::open(const std::string& path,
                                                         double timeout_s) {
  auto connected = connect_to(path, timeout_s);
  if (!connected) {
    return tl::unexpected(path + ": " + error_text(connected.error()));
  }
  FrameSocket socket(*std::move(connected));
  if (const std::string why = socket.greet(timeout_s); !why.empty()) {
    return tl::unexpected(path + ": " + why);
  }
  return socket;
}

// An answer that is not read when the socket closes is an error (ECONNRESET) at the other end, in
// place of the frames that it has not read yet.
FrameSocket::~FrameSocket() {
  if (socket_.is_open()) {
    hang_up();
    while (receive().what == Received::What::frame) {
    }
  }
}

std::string FrameSocket::greet(double timeout_s) {
  if (!send({.call = MachineCall::disable})) {
    return errno == EPIPE || errno == ECONNRESET ? kHangsUp : error_text(errno);
  }
  if (!has_input_within(timeout_s, socket_)) {
    return fmt::format("the machine does not answer within {} s", timeout_s);
  }
  const Received received = receive();
  if (received.what != Received::What::frame) {
    return kHangsUp;
  }
  if (!received.answer) {
    return fmt::format("the machine answers {} bytes that are no answer of version {}",
                       received.bytes, kFrameVersion);
  }
  greeting_ = *received.answer;
  return "";
}

bool FrameSocket::send(const ToldFrame& told) noexcept {
  const ToldBytes bytes = to_bytes(told);
  return ::send(socket_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL) ==
         static_cast<ssize_t>(bytes.size());
}

FrameSocket::Received FrameSocket::receive() noexcept {
  std::array<std::byte, kAnswerBytes + 1> bytes{};  // a byte too many shows that it is no answer
  const ssize_t count =
      ::recv(socket_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_TRUNC);
  if (count < 0 && errno == EAGAIN) {
    return {};
  }
  if (count <= 0) {
    return {.what = Received::What::hung_up};
  }
  const auto size = static_cast<std::size_t>(count);
  return {.what = Received::What::frame,
          .bytes = size,
          .answer = answer_from(std::span(bytes).first(std::min(size, bytes.size())))};
}

void FrameSocket::hang_up() noexcept {
  ::shutdown(socket_.number(), SHUT_RDWR);
}

}  // namespace kerf::program
