// Where commands come from and answers go to: descriptors that were handed over, or a Unix socket.
#pragma once

#include <string>
#include <unistd.h>
#include <utility>

#include <tl/expected.hpp>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

// The file of a socket, which goes with its owner.
class SocketFile {
 public:
  SocketFile() = default;
  explicit SocketFile(std::string path) noexcept : path_(std::move(path)) {}
  ~SocketFile() {
    if (!path_.empty()) {
      ::unlink(path_.c_str());
    }
  }
  SocketFile(SocketFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  SocketFile& operator=(SocketFile&& other) noexcept {
    std::swap(path_, other.path_);
    return *this;
  }

 private:
  std::string path_;
};

// What --control names. One of the two is open.
struct ControlEndpoint {
  // "3": a descriptor for both ways; "4,5": one to read from and one to write to.
  Descriptor in{};
  Descriptor out{};  // closed where it is the same
  // Else a path: a socket that listens there, for its owner alone (mode 0600).
  Descriptor listens{};
  SocketFile file{};  // of that
};

// A socket that nobody listens at any more is replaced. Error: the reason, with what was named.
tl::expected<ControlEndpoint, std::string> open_control(const std::string& named);

}  // namespace kerf::program
