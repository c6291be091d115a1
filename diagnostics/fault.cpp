#include "diagnostics/fault.hpp"

namespace kerf::diagnostics {

Failure failure(Fault fault) {
  return Failure(std::make_unique<Fault>(std::move(fault)));
}

Failure fail(std::size_t offset_in_line, const ErrorPage& page, std::string message) {
  return failure({static_cast<std::uint32_t>(offset_in_line), std::move(message), &page});
}

}  // namespace kerf::diagnostics
