// G10: the program writes work offsets and the tool table.
#pragma once

#include <string_view>

#include "parser/modal/running_block.hpp"

namespace kerf::parser {

// L1, L2, L10, L11 and L20.
Done set_data(const RunningBlock& at, ModalState& state, ToolTable& tools);

// What kinds of G10 share, those of a dialect too.
// Words that only some kinds of G10 use.
Done check_data_words(const Block& block, std::string_view name, Letters usable);
// P, which must be in the range.
struct Numbers {
  int least;
  int most;
};
Expected<int> data_number(const RunningBlock& at, std::string_view name, Numbers range);
// The origin of the auxiliary axes of L2, or of L20 where the place of the axes gets the
// coordinates of the words.
void set_auxiliary_origin(const RunningBlock& at, const ModalState& state, WorkOffset& offset,
                          bool from_position);

}  // namespace kerf::parser
