// Which line of one program is which of another.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::program {

// Lines from `first` to `last`, counted from 1; last < first: none.
struct LineSpan {
  std::uint32_t first = 1;
  std::uint32_t last = 0;

  [[nodiscard]] bool is_empty() const noexcept { return last < first; }
  [[nodiscard]] std::uint32_t count() const noexcept { return is_empty() ? 0 : last + 1 - first; }
};

// Lines of the first program, and what stands in their place in the second.
struct MatchedLines {
  LineSpan first{};
  LineSpan second{};
};

// All lines of both, in their order, each in one pair. Lines that say the same are pairs of one
// line each: sequence numbers, comments, blanks and small letters make no difference. So are those
// between them, where both programs have as many there; else all of them are one pair.
//
// Lines that are only once in both go first and hold what lies between them apart, as in a patience
// diff, again and again, at most 64 times. Work and memory grow as n log n with the number of
// lines.
[[nodiscard]] std::vector<MatchedLines> match_lines(const std::vector<std::string>& first,
                                                    const std::vector<std::string>& second);

// The lines of a program, by their numbers as it is read, without their ends.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text);

}  // namespace kerf::program
