#include "programs/kerf/exit_status.hpp"

#include <new>
#include <system_error>

namespace kerf::program {

ExitStatus status_of(const std::exception& exception) noexcept {
  const bool refused_by_system = dynamic_cast<const std::bad_alloc*>(&exception) != nullptr ||
                                 dynamic_cast<const std::system_error*>(&exception) != nullptr;
  return refused_by_system ? ExitStatus::io_error : ExitStatus::internal_error;
}

}  // namespace kerf::program
