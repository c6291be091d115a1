// All error pages in one row.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

// In the order of their numbers.
std::span<const ErrorPage* const> catalogue();

// Null: no page has the number.
const ErrorPage* find_page(std::uint16_t number);

// The whole program that has this fault.
std::string trigger_of(const ErrorPage& page);

}  // namespace kerf::errors
