// What is read is not written over, and no file is written twice.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "programs/kerf/options.hpp"

namespace kerf::program {

// What a command reads beside the files that its options name.
struct AlsoRead {
  std::vector<std::string> files{};  // that machine files name
  bool is_fanuc = false;             // a program may call one whose name has no extension
};

// Why a file that the options name for output is not to be written, as a sentence; nothing: each
// may be.
std::optional<std::string> written_over(const Options& options, const AlsoRead& also);

}  // namespace kerf::program
