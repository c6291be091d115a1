// The pages of all errors and warnings, errors::kNotText and so on, as pages.def lists them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <kerf/diagnostic.hpp>

namespace kerf::errors {

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the list is written once.
#define ERROR_PAGE(name, ...) extern const ErrorPage name;
#include "diagnostics/errors/pages.def"
#undef ERROR_PAGE

// In the order of their numbers.
std::span<const ErrorPage* const> catalogue();

// Null: no page has the number.
const ErrorPage* find_page(std::uint16_t number);

// The whole program that has this fault.
std::string trigger_of(const ErrorPage& page);

}  // namespace kerf::errors
