// What is wrong with a machine's settings or a kernel's options.
#pragma once

#include <string>

namespace kerf {

struct SettingsError {
  unsigned line = 0;  // of a machine file, 1-based; 0 where no place is to blame
  unsigned column = 0;
  std::string message;
};

}  // namespace kerf
