// A line of the program, or a part of it, in a form that can be shown.
#pragma once

#include <cstdint>
#include <string_view>

#include <kerf/diagnostic.hpp>

namespace kerf::diagnostics {

using kerf::Excerpt;

// What to show of `line` for the byte at `offset` (at most its length). Of a long line it is some
// hundred bytes round the place, with "..." where more was left out. A tab becomes one blank, and
// what is no character becomes U+FFFD; where that is a third of it or more there is no text.
Excerpt excerpt_of(std::string_view line, std::uint32_t offset);

}  // namespace kerf::diagnostics
