// Why a move cannot be run.
#pragma once

#include <cstdint>
#include <string>

namespace kerf::smoothing {

struct PathError {
  std::uint32_t line = 0;
  std::string message;
};

}  // namespace kerf::smoothing
