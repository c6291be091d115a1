// The N numbers of a text, for GOTO.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace kerf::parser {

struct SequenceNumber {
  std::uint32_t number = 0;
  std::uint32_t line = 0;    // index in the text
  std::uint32_t around = 0;  // what opens the innermost structure around it
  std::uint32_t next = 0;    // index + 1 of the next one with this number; 0: none
};

// In the order of the text. The table that finds a number is built at the first search, so that a
// program without GOTO does not pay for it.
class SequenceNumbers {
 public:
  void add(std::uint32_t number, std::uint32_t line, std::uint32_t around) {
    all_.push_back({number, line, around, 0});
    if (indexed_ > 0) {
      index();
    }
  }
  // The first one with this number; nullptr: none so far. Valid until the next add().
  [[nodiscard]] const SequenceNumber* first(std::uint32_t number) {
    index();
    const auto found = chains_.find(number);
    return found == chains_.end() ? nullptr : &all_[found->second.first];
  }
  // The number added last; 0: none.
  [[nodiscard]] std::uint32_t last() const { return all_.empty() ? 0 : all_.back().number; }
  [[nodiscard]] const SequenceNumber* behind(const SequenceNumber& one) const {
    return one.next == 0 ? nullptr : &all_[one.next - 1];
  }

 private:
  struct Chain {
    std::size_t first = 0;
    std::size_t last = 0;
  };

  void index() {
    for (; indexed_ < all_.size(); ++indexed_) {
      const auto [chain, fresh] =
          chains_.try_emplace(all_[indexed_].number, Chain{indexed_, indexed_});
      if (!fresh) {
        all_[chain->second.last].next = static_cast<std::uint32_t>(indexed_ + 1);
        chain->second.last = indexed_;
      }
    }
  }

  std::vector<SequenceNumber> all_;
  std::unordered_map<std::uint32_t, Chain> chains_;
  std::size_t indexed_ = 0;
};

}  // namespace kerf::parser
