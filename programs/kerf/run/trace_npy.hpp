// Ticks as a structured array of NumPy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "programs/kerf/run/trace_row.hpp"

namespace kerf::program {

// The head of a file in format 1.0 of NPY: the names of trace_header() as fields, the line as an
// unsigned whole number, the limit as text, all else as doubles. As long for any count of rows, so
// that it can be written again once the count is known.
[[nodiscard]] std::string npy_header(const TraceColumns& columns, std::uint64_t rows);

[[nodiscard]] std::size_t npy_row_bytes(const TraceColumns& columns) noexcept;

// One record. Not rounded; the time is that many periods, u is not a number where the tick is on no
// NURBS. Returns the end of what was written at `at`, which has room for npy_row_bytes().
char* write_npy_row(char* at, const TickRecord& record, double period_s,
                    const TraceColumns& columns) noexcept;

}  // namespace kerf::program
