// Something wrong in one line, before it is known which line it is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "diagnostics/diagnostic_list.hpp"
#include "diagnostics/errors/error_page.hpp"

namespace kerf::diagnostics {

// Whoever says that something is wrong says why: without a page there is no fault.
struct Fault {
  Fault() = default;  // nothing is wrong
  // Not inline: units return faults, and what is not needed must not crowd their code.
  Fault(Fault&&) noexcept;
  Fault(const Fault&);
  Fault& operator=(Fault&&) noexcept;
  Fault& operator=(const Fault&);
  ~Fault();
  Fault(std::uint32_t offset_in_line, std::string what, const ErrorPage* why)
      : offset(offset_in_line), message(std::move(what)), page(why) {}

  std::uint32_t offset = 0;  // bytes from the start of the line
  std::string message;
  const ErrorPage* page = nullptr;  // nothing is wrong: null
  // Of an earlier line that is to blame; `offset` does not count then.
  std::optional<DiagnosticPlace> elsewhere;
};

template <class Value>
using Expected = tl::expected<Value, Fault>;
using Done = Expected<void>;

tl::unexpected<Fault> fail(std::uint32_t offset_in_line, const ErrorPage& page,
                           std::string message);

// What went wrong, to be handed on.
template <class Value>
tl::unexpected<Fault> fault_of(Expected<Value>& failed) {
  return tl::unexpected(std::move(failed.error()));
}

}  // namespace kerf::diagnostics
