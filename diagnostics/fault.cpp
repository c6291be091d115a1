#include "diagnostics/fault.hpp"

namespace kerf::diagnostics {

Fault::Fault(Fault&&) noexcept = default;
Fault::Fault(const Fault&) = default;
Fault& Fault::operator=(Fault&&) noexcept = default;
Fault& Fault::operator=(const Fault&) = default;
Fault::~Fault() = default;

tl::unexpected<Fault> fail(std::uint32_t offset_in_line, const ErrorPage& page,
                           std::string message) {
  return tl::unexpected(Fault(offset_in_line, std::move(message), &page));
}

}  // namespace kerf::diagnostics
