// The labels of one text and what they name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace kerf::parser {

// Statements that a label names, as indices; 0: none.
struct LabelUse {
  std::uint32_t sub = 0;      // o100 sub
  std::uint32_t program = 0;  // O100 alone
};

class Labels {
 public:
  // The index of a label, which is entered if it is new; never 0.
  std::uint32_t index_of(std::string_view label) {
    const auto found = indices_.find(label);
    if (found != indices_.end()) {
      return found->second;
    }
    const auto index = static_cast<std::uint32_t>(uses_.size());
    names_.push_back(&indices_.emplace(label, index).first->first);
    uses_.emplace_back();
    return index;
  }
  [[nodiscard]] LabelUse find(std::string_view label) const {
    const auto found = indices_.find(label);
    return found == indices_.end() ? LabelUse{} : uses_[found->second];
  }
  [[nodiscard]] LabelUse& use(std::uint32_t index) { return uses_[index]; }
  [[nodiscard]] const std::string& name(std::uint32_t index) const { return *names_[index]; }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>{}(text);
    }
  };
  std::unordered_map<std::string, std::uint32_t, Hash, std::equal_to<>> indices_;
  std::vector<const std::string*> names_{nullptr};  // into indices_, whose keys do not move
  std::vector<LabelUse> uses_{LabelUse{}};
};

}  // namespace kerf::parser
