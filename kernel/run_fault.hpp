// What a run did not keep.
#pragma once

#include <cstdint>
#include <string>

namespace kerf {

// A promise that does not hold: a defect of kerf, not of the program.
struct RunFault {
  std::uint32_t line = 0;  // of the program; 0: none is known
  std::string what;
};

}  // namespace kerf
