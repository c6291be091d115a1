// Comments that say something to the operator or to the program: (MSG, text) and its like.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <kerf/program_data.hpp>

#include "parser/expressions/parameters.hpp"

namespace kerf::parser {

struct ActiveComment {
  std::optional<ProgramMessage::Kind> kind{};  // nothing: (ABORT, text)
  std::string_view text{};                     // without the blanks before it
};

// `comment` begins after its '(' and may go on after its ')'. Nothing: a plain comment.
std::optional<ActiveComment> active_comment(std::string_view comment);

// The text that the operator sees. In PRINT and DEBUG, variables are numbers of six decimals, as
// LinuxCNC writes them; one that does not exist is ######.
std::string message_text(const ActiveComment& comment, Parameters& parameters);

}  // namespace kerf::parser
