// libFuzzer's mutator for part programs: half of the time it works on lines and words, the other
// half libFuzzer's own byte changes are left to find what no grammar knows.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/block_generator.hpp"
#include "tests/fuzz/judge/fuzz_input.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using kerf::fuzz::kHead;

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

// Gives another value to one word of the line.
void change_value(std::string& line, std::minstd_rand& random, kerf::fuzz::BlockGenerator& more) {
  std::vector<std::size_t> letters;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (is_letter(line[i])) {
      letters.push_back(i);
    }
  }
  if (letters.empty()) {
    line.insert(0, more.word());
    return;
  }
  const std::size_t which = random() % letters.size();
  const std::size_t begin = letters[which] + 1;
  const std::size_t end = which + 1 < letters.size() ? letters[which + 1] : line.size() - 1;
  line.replace(begin, end > begin ? end - begin : 0, more.value());
}

void change_lines(std::vector<std::string>& lines, std::uint32_t seed) {
  std::minstd_rand random(seed);
  kerf::fuzz::BlockGenerator more(static_cast<std::uint32_t>(random()));
  if (lines.empty()) {
    lines.push_back(more.lines());
    return;
  }
  const auto at = static_cast<std::ptrdiff_t>(random() % lines.size());
  const auto other = static_cast<std::ptrdiff_t>(random() % lines.size());
  switch (random() % 8) {
    case 0:
      lines.erase(lines.begin() + at);
      break;
    case 1:
      std::swap(lines[static_cast<std::size_t>(at)], lines[static_cast<std::size_t>(other)]);
      break;
    case 2: {
      const std::string copy = lines[static_cast<std::size_t>(other)];
      lines.insert(lines.begin() + at, copy);
      break;
    }
    case 3: {
      std::string& line = lines[static_cast<std::size_t>(at)];
      line.insert(line.empty() ? 0 : line.size() - 1, " " + more.word());
      break;
    }
    case 4:
    case 5:
      change_value(lines[static_cast<std::size_t>(at)], random, more);
      break;
    default:
      lines.insert(lines.begin() + at, more.lines());
      break;
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  if (seed % 2 == 0 || size < kHead || max_size <= kHead) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  std::vector<std::string> lines =
      lines_of({reinterpret_cast<const char*>(data) + kHead, size - kHead});
  change_lines(lines, seed / 2);
  std::string text;
  for (const std::string& line : lines) {
    text += line;
  }
  const std::size_t length = std::min(text.size(), max_size - kHead);
  std::memcpy(data + kHead, text.data(), length);
  return kHead + length;
}
