// The lines of a program that may be read again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "parser/text/line_splitter.hpp"

namespace kerf::parser {

struct StoredLine {
  const char* text = nullptr;
  std::uint32_t length = 0;
  std::uint32_t statement : 30 = 0;  // index of the flow statement it is; 0: a plain line
  std::uint32_t too_long : 1 = 0;
  std::uint32_t left_out : 1 = 0;

  [[nodiscard]] std::string_view view() const { return {text, length}; }
};

// Text in chunks that never move, so that a line is found in one step and views stay valid while
// more is appended. Holds the text, 16 bytes a line and at most a chunk of each more.
class TextStore {
 public:
  // The line's index; lines are counted from 0.
  std::uint32_t append(const NumberedLine& line);
  [[nodiscard]] std::uint32_t size() const { return lines_; }
  [[nodiscard]] const StoredLine& operator[](std::uint32_t index) const {
    return (*blocks_[index / kBlock])[index % kBlock];
  }
  [[nodiscard]] StoredLine& operator[](std::uint32_t index) {
    return (*blocks_[index / kBlock])[index % kBlock];
  }
  [[nodiscard]] std::size_t text_bytes() const { return text_bytes_; }
  [[nodiscard]] std::size_t held_bytes() const {
    return chunks_.size() * kChunk + blocks_.size() * sizeof(Block);
  }

 private:
  static constexpr std::size_t kChunk = 4 * LineSplitter::kMaxLine;
  static constexpr std::uint32_t kBlock = 4096;
  using Block = std::array<StoredLine, kBlock>;

  using Chunk = std::array<char, kChunk>;

  std::vector<std::unique_ptr<Chunk>> chunks_;
  std::vector<std::unique_ptr<Block>> blocks_;
  std::size_t used_ = 0;  // of the last chunk
  std::size_t text_bytes_ = 0;
  std::uint32_t lines_ = 0;
};

}  // namespace kerf::parser
