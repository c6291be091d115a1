// G10: the program writes work offsets and the tool table.
#pragma once

#include <string_view>

#include "parser/modal/running_block.hpp"

namespace kerf::parser {

// L1, L2, L10, L11 and L20.
Done set_data(const RunningBlock& at, ModalState& state, ToolTable& tools);

// Refuses words that this kind of G10 does not use.
Done check_data_words(const BlockWords& block, std::string_view name, Letters usable);
// The value of P, a whole number in the range.
struct NumberRange {
  int least;
  int most;
};
Expected<int> data_number(const RunningBlock& at, std::string_view name, NumberRange range);
// Sets the origin of the auxiliary axes: to the words (L2), or so that the axes stand at the words
// (L20, `from_position`).
void set_auxiliary_origin(const RunningBlock& at, const ModalState& state, WorkOffset& offset,
                          bool from_position);

}  // namespace kerf::parser
