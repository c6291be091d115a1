// What is wrong where the number after an address letter should be.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "diagnostics/fault.hpp"
#include "parser/block/block.hpp"
#include "parser/text/number.hpp"

namespace kerf::parser {

// The letters that `rest` begins with.
inline std::string_view letters_at(std::string_view rest) {
  return rest.substr(
      0, static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), detail::is_letter) -
                                  rest.begin()));
}

// Precondition: a letter stands at `letter_at` in the block's line, and no number after it.
diagnostics::Fault explain_missing_number(const BlockWords& block, std::size_t letter_at);

}  // namespace kerf::parser
