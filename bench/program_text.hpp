// Reads what the benchmarks run.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace kerf::bench {

// A file of the source tree, whole. Throws std::runtime_error if it cannot be read.
inline std::string source_file(const std::string& name) {
  const std::string path = std::string(KERF_SOURCE_DIR) + "/" + name;
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) {
    throw std::runtime_error(path + " cannot be read");
  }
  return text.str();
}

}  // namespace kerf::bench
