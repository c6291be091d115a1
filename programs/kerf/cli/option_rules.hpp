// The values that options may have, and which options go together.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <kerf/program_data.hpp>

#include "programs/kerf/options.hpp"

namespace kerf::program {

// "all", or numbers from 1 to 9 with commas between them; nothing where it is neither.
std::optional<parser::BlockDelete> block_delete_of(std::string_view text);

// "90", "90s", "5min", "2.5h", "30d" in seconds; nothing where it is none of these, below 0 or
// more than 1e10 s.
std::optional<double> duration_s_of(std::string_view text);

// "1000", "500MB", "4GiB" in bytes, at least 1; kB, MB, GB, TB are powers of 1000, KiB to TiB of
// 1024. Nothing where it is none of these, or more than 2^60.
std::optional<std::uint64_t> bytes_of(std::string_view text);

// "12", or "12:3" for the third time that the line runs; nothing where it is neither.
std::optional<StartLine> start_line_of(std::string_view text);

// Why options do not go together that are valid one by one, as a sentence; nothing: they do.
std::optional<std::string> contradiction(const Options& options);

}  // namespace kerf::program
