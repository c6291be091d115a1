// What values options may have, and which of them go together.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "parser/block_delete.hpp"
#include "programs/options.hpp"

namespace kerf::program {

// "all", or numbers from 1 to 9 with commas between them; nothing where it is neither.
std::optional<parser::BlockDelete> block_delete_of(std::string_view text);

// What is wrong with the options that the command line itself lets pass, as a sentence; nothing:
// they go together.
std::optional<std::string> contradiction(const Options& options);

}  // namespace kerf::program
