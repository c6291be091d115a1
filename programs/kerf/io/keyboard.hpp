// The keys of the person at the terminal, one by one.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

namespace kerf::program {

// While it lives, keys come without Return and are not shown. For standard input, where that is the
// terminal of this process and in the foreground; elsewhere it is closed. At most one may live.
class Keyboard {
 public:
  Keyboard() noexcept;
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  // Would it be open?
  [[nodiscard]] static bool has_terminal() noexcept;
  [[nodiscard]] bool is_open() const noexcept { return open_; }
  // Nothing: none came in time, or one that is several characters, as arrows are.
  [[nodiscard]] std::optional<char> key(std::chrono::milliseconds wait) noexcept;

  // Gives the terminal back, as the destructor does. Safe in a signal's handler.
  static void restore() noexcept;

 private:
  // Of what was read: nothing is left of it, or only such sequences.
  [[nodiscard]] std::optional<char> next_read() noexcept;

  bool open_ = false;
  // Read and not given yet.
  std::array<char, 16> read_{};
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace kerf::program
