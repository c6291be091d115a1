// The text of flow statements in pieces: labels, keywords, brackets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <kerf/program_data.hpp>

#include "parser/flow/statement.hpp"

namespace kerf::parser {

// Where a block's words begin: after blanks, block delete and line number.
struct BlockStart {
  std::size_t at = 0;
  std::optional<std::uint32_t> line_number;  // of a whole N of at most nine digits
};
BlockStart find_block_start(std::string_view line);

// Offset after the label that begins at `at`: digits, <name> or [expression]; `at` itself where
// there is none.
std::size_t behind_label(std::string_view line, std::size_t at);
// A label as it is compared: `0100` is "100", `<Foo Bar>` is "foobar"; `[#1]` stays itself.
std::string plain_label(std::string_view line, const Statement& statement);
// As a message names it: o100 or o<foobar>.
std::string shown_label(std::string_view plain_label);

// Whether only blanks and comments are left from `at` on.
bool only_comment_left(std::string_view line, std::size_t at);
// Offset after the bracket that closes the one at `at`; nothing where none does.
std::optional<std::size_t> behind_brackets(std::string_view line, std::size_t at);
std::size_t skip_blanks(std::string_view line, std::size_t at);
// By block delete.
bool is_left_out(std::string_view line, const BlockDelete& switches);
// Offset after `keyword` at `at`, whatever its case and the blanks in it; 0: no.
std::size_t behind_keyword(std::string_view line, std::size_t at, std::string_view keyword);

}  // namespace kerf::parser
