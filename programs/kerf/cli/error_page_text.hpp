// The error pages in words: what `kerf errors` prints.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace kerf::program {

// One line for each page.
std::string error_page_list();

// The page with that identifier ("E0123", also "e123" and "123"). Error: what is wrong with it.
tl::expected<std::string, std::string> error_page_text(std::string_view identifier);

// docs/errors.md.
std::string error_pages_markdown();

}  // namespace kerf::program
