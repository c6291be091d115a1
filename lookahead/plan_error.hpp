// Why a move cannot be planned.
#pragma once

#include <cstdint>
#include <string>

namespace kerf::lookahead {

struct PlanError {
  std::uint32_t line = 0;
  std::string message;
};

}  // namespace kerf::lookahead
