// Text to moves, long programs.
#pragma once

#include <string_view>

namespace kerf::bench {

// Reads each of the long programs a few times on one core and prints the best CPU time as a
// Markdown table on standard output. Exit status: 0, 1 where a target is missed or a program has
// errors.
int parse();

// Reads a short version of one of them once, in a function of its own (`counted_parse`), for a tool
// that counts instructions, and prints how many lines that were. `name` as in the table.
// Exit status: 0, 1 where the program has errors, 2 where there is no program of that name.
int parse_once(std::string_view name);

}  // namespace kerf::bench
