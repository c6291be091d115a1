// O-words as they are written, for messages.
#pragma once

#include <string_view>

#include "parser/flow/statement.hpp"

namespace kerf::parser {

std::string_view name_of(Keyword keyword);
// What closes the structure that `opener` opens.
std::string_view close_of(Keyword opener);

}  // namespace kerf::parser
