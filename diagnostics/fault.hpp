// Something wrong in one line, before it is known which line it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "diagnostics/diagnostic_list.hpp"

namespace kerf::diagnostics {

// Whoever says that something is wrong says why: without a page there is no fault.
struct Fault {
  Fault() = default;  // nothing is wrong
  Fault(std::uint32_t offset_in_line, std::string what, const ErrorPage* why)
      : offset(offset_in_line), message(std::move(what)), page(why) {}

  std::uint32_t offset = 0;  // bytes from the start of the line
  std::string message;
  const ErrorPage* page = nullptr;  // nothing is wrong: null
  // Of an earlier line that is to blame; `offset` does not count then.
  std::optional<DiagnosticPlace> elsewhere;
};

// On its way up a fault is as small as a pointer, so that results cost little where all is well.
using FaultPointer = std::unique_ptr<Fault>;  // never null
using Failure = tl::unexpected<FaultPointer>;
template <class Value>
using Expected = tl::expected<Value, FaultPointer>;
using Done = Expected<void>;

Failure failure(Fault fault);
Failure fail(std::size_t offset_in_line, const ErrorPage& page, std::string message);

// What went wrong, to be handed on.
template <class Value>
Failure fault_of(Expected<Value>& failed) {
  return Failure(std::move(failed.error()));
}

}  // namespace kerf::diagnostics
