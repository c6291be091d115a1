// The operator's block delete switches: which blocks with a '/' before them are left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kerf::parser {

// Nine switches, as Fanuc has them: /2 belongs to the second, a '/' alone to the first.
class BlockDelete {
 public:
  static constexpr unsigned kSwitches = 9;

  // None is on: every block runs.
  constexpr BlockDelete() = default;
  // All are on: no block with a '/' runs.
  static constexpr BlockDelete all() {
    BlockDelete switches;
    switches.on_ = 0xFFFF;
    return switches;
  }
  // Precondition: 1 <= number <= kSwitches.
  constexpr void switch_on(unsigned number) {
    on_ = static_cast<std::uint16_t>(on_ | (1U << number));
  }

  // Whether a line runs that has its '/' at `at`.
  [[nodiscard]] constexpr bool leaves_out(std::string_view line, std::size_t at) const {
    if (on_ == 0) {
      return false;
    }
    ++at;
    while (at < line.size() && (line[at] == ' ' || line[at] == '\t')) {
      ++at;
    }
    const char c = at < line.size() ? line[at] : '1';
    const unsigned number = c >= '1' && c <= '9' ? static_cast<unsigned>(c - '0') : 1U;
    return ((on_ >> number) & 1U) != 0;
  }

  friend constexpr bool operator==(BlockDelete, BlockDelete) = default;

 private:
  std::uint16_t on_ = 0;  // bit n is switch n
};

}  // namespace kerf::parser
