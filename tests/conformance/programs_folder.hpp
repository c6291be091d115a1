// Where the real programs by others are, which are not part of the sources.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace kerf::conformance {

// KERF_PROGRAMS_DIR, or beside the source tree. It need not exist.
inline std::filesystem::path programs_folder() {
  const char* const given = std::getenv("KERF_PROGRAMS_DIR");
  return given != nullptr
             ? std::filesystem::path(given)
             : std::filesystem::path(KERF_SOURCE_DIR).parent_path() / "shared/reference/programs";
}

}  // namespace kerf::conformance
