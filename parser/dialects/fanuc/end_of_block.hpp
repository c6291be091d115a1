// Fanuc listings write the end of a block as ';', where other controls begin a comment.
#pragma once

#include <string_view>

namespace kerf::parser {

// The text behind a ';' is words, as in `G1 X5; G1 Y7;`, and no remark in somebody's language.
bool reads_as_block(std::string_view text);

}  // namespace kerf::parser
