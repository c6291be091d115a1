// Which codes, or words, are in force when.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::program {

// From its tick up to that of the next.
struct CodeRun {
  std::int64_t tick = 0;
  std::uint32_t codes = 0;  // its place in texts()
};

// The first 200,000 changes; after them nothing is known.
class CodeRuns {
 public:
  static constexpr std::size_t kMaxRuns = 200'000;

  // Ticks come in ascending order. codes: "G1 G17 G21 ..."; empty: not known yet.
  void add(std::int64_t tick, std::string_view codes);

  [[nodiscard]] const std::vector<CodeRun>& runs() const noexcept { return runs_; }
  // Each once.
  [[nodiscard]] const std::vector<std::string>& texts() const noexcept { return texts_; }

 private:
  std::string last_;
  std::vector<CodeRun> runs_;
  std::vector<std::string> texts_;
  std::map<std::string, std::uint32_t, std::less<>> places_;
};

}  // namespace kerf::program
