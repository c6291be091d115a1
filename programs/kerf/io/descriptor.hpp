// A file descriptor with an owner, and whole writes to one.
#pragma once

#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>

#include <tl/expected.hpp>

namespace kerf::program {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) noexcept : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  [[nodiscard]] int number() const noexcept { return number_; }
  [[nodiscard]] bool is_open() const noexcept { return number_ >= 0; }

  // 0, or the errno of a write that failed only now.
  int close() noexcept;
  // The number, which somebody else owns from now on.
  [[nodiscard]] int release() && noexcept { return std::exchange(number_, -1); }

 private:
  int number_ = -1;
};

// Writes all of it, however many calls that takes. 0, or the errno. Where nobody takes it from a
// pipe or a terminal, a request to stop (interrupt.hpp) ends the wait: EINTR.
int write_all(int descriptor, std::string_view bytes) noexcept;

// Opens a regular file for reading; never waits for a file of another kind. Error: the reason.
tl::expected<Descriptor, std::string> open_regular(const std::string& path);

// "No space left on device", the same in every locale.
std::string error_text(int error_number);

}  // namespace kerf::program
