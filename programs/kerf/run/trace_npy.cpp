#include "programs/kerf/run/trace_npy.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <string_view>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/report/constraint_text.hpp"

namespace kerf::program {

namespace {

static_assert(std::endian::native == std::endian::little, "the fields say '<'");

constexpr std::size_t kDoubles = 13;  // of every row
constexpr std::size_t kLimitBytes = 24;

template <typename Value>
char* put(char* at, Value value) noexcept {
  std::memcpy(at, &value, sizeof value);
  return at + sizeof value;
}

std::string_view type_of(std::string_view field) {
  if (field == "line") {
    return "<u4";
  }
  return field == "limit" ? "S24" : "<f8";
}

std::string fields_of(const TraceColumns& columns) {
  std::string names = trace_header(columns);
  names.pop_back();  // the end of the line
  std::string fields;
  for (std::size_t at = 0; at < names.size();) {
    const std::size_t end = std::min(names.find(',', at), names.size());
    const std::string_view name = std::string_view(names).substr(at, end - at);
    fields += fmt::format("('{}', '{}'), ", name, type_of(name));
    at = end + 1;
  }
  return fields;
}

}  // namespace

std::string npy_header(const TraceColumns& columns, std::uint64_t rows) {
  constexpr std::size_t kAligned = 64;
  constexpr std::size_t kBefore = 10;  // magic, version, length
  std::string text = fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({:20},), }}",
                                 fields_of(columns), rows);
  text.append(kAligned - (kBefore + text.size() + 1) % kAligned, ' ').push_back('\n');
  std::string header = "\x93NUMPY";
  header.push_back('\1');
  header.push_back('\0');
  header.push_back(static_cast<char>(text.size() & 0xFFU));
  header.push_back(static_cast<char>(text.size() >> 8U));
  return header + text;
}

std::size_t npy_row_bytes(const TraceColumns& columns) noexcept {
  return (kDoubles + columns.axes.size()) * sizeof(double) + sizeof(std::uint32_t) +
         (columns.limit ? kLimitBytes : 0);
}

char* write_npy_row(char* at, const TickRecord& record, double period_s,
                    const TraceColumns& columns) noexcept {
  at = put(at, static_cast<double>(record.tick) * period_s);
  at = put(at, record.line);
  for (const double value :
       {record.motion.s_mm, record.motion.v_mm_s, record.motion.a_mm_s2, record.motion.j_mm_s3}) {
    at = put(at, value);
  }
  for (const curves::Position* position : {&record.position_mm, &record.actual_mm}) {
    for (const double coordinate : *position) {
      at = put(at, coordinate);
    }
  }
  at = put(at, record.detail.curve_parameter.value_or(std::numeric_limits<double>::quiet_NaN()));
  at = put(at, record.detail.chord_error_mm);
  for (const ExtraAxis& axis : columns.axes) {
    at = put(at, axis.factor * record.extra_rad_mm[axis.index]);
  }
  if (columns.limit) {
    const std::string_view key = key_of(record.limit).substr(0, kLimitBytes);
    std::fill(std::copy(key.begin(), key.end(), at), at + kLimitBytes, '\0');
    at += kLimitBytes;
  }
  return at;
}

}  // namespace kerf::program
