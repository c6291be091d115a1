// What the tests of the machine file share.
#pragma once

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/machine.hpp>

namespace kerf::test {

// Bounds everything, and stands before the lines that a test is about.
inline const std::string kBounded =
    "[path]\n"
    "max_velocity_mm_s = 100\n"
    "max_acceleration_mm_s2 = 3000\n"
    "max_jerk_mm_s3 = 55_000\n";
inline constexpr unsigned kBoundedLines = 4;

// A file of the clone.
inline std::string read_text(const std::string& path) {
  std::ifstream file(std::string(KERF_SOURCE_DIR) + "/" + path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

using Lines = std::vector<std::string>;

// As the user sees them, for a file that is called m.toml.
inline Lines errors_of(const std::string& toml) {
  Lines lines;
  if (const auto settings = parse_machine_file(toml); !settings) {
    for (const SettingsError& error : settings.error()) {
      lines.push_back(to_string(error, "m.toml"));
    }
  }
  return lines;
}

}  // namespace kerf::test
