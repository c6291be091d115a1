#include "parser/flow/text_store.hpp"

#include <algorithm>

namespace kerf::parser {

std::uint32_t TextStore::append(const NumberedLine& line) {
  if (chunks_.empty() || used_ + line.text.size() > kChunk) {
    chunks_.push_back(std::make_unique_for_overwrite<Chunk>());
    used_ = 0;
  }
  if (lines_ % kBlock == 0) {
    blocks_.push_back(std::make_unique<Block>());
  }
  char* const place = chunks_.back()->data() + used_;
  std::copy(line.text.begin(), line.text.end(), place);
  StoredLine& stored = (*this)[lines_];
  stored.text = place;
  stored.length = static_cast<std::uint32_t>(line.text.size());
  stored.too_long = line.too_long ? 1 : 0;
  stored.left_out = line.left_out ? 1 : 0;
  used_ += line.text.size();
  text_bytes_ += line.text.size();
  return lines_++;
}

}  // namespace kerf::parser
