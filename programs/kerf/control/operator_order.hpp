// What is asked of a run, as values that can be written down and given once more.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <kerf/controller.hpp>

namespace kerf::program {

struct SingleBlock {
  bool is_on = false;
};
struct OptionalStop {
  bool is_on = false;
};
struct MdiLine {
  std::string text;
};

// The commands are those that come without a value.
using OperatorOrder = std::variant<kerf::Command, Overrides, SingleBlock, OptionalStop, BlockDelete,
                                   FeedInputs, Tool, Jog, MdiLine>;

// One line of text from which order_from() makes the same order, to the last bit.
std::string text_of(const OperatorOrder& order);
// Nothing: it is no such text.
std::optional<OperatorOrder> order_from(std::string_view text);

}  // namespace kerf::program
