#include "programs/kerf/run/trace_row.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "programs/kerf/report/constraint_text.hpp"

namespace kerf::program {

namespace {

constexpr int kLengthDecimals = 10;
constexpr int kMotionDecimals = 6;
constexpr int kMinTimeDecimals = 6;
constexpr int kMaxTimeDecimals = 12;
constexpr std::size_t kMaxNumberBytes = 330;

// Half of the last decimal: below it the number is written as 0, without a sign.
constexpr double half_unit(int decimals) noexcept {
  double unit = 0.5;
  for (int i = 0; i < decimals; ++i) {
    unit /= 10.0;
  }
  return unit;
}

template <int kDecimals>
char* write_number(char* at, double value) noexcept {
  constexpr double kNothing = half_unit(kDecimals);
  const double shown = std::abs(value) < kNothing ? 0.0 : value;
  return std::to_chars(at, at + kMaxNumberBytes, shown, std::chars_format::fixed, kDecimals).ptr;
}

}  // namespace

TickClock::TickClock(double period_s) noexcept : period_s_(period_s) {
  std::int64_t unit = 1'000'000;
  for (int decimals = kMinTimeDecimals; decimals <= kMaxTimeDecimals; ++decimals, unit *= 10) {
    const double units = period_s * static_cast<double>(unit);
    const double whole = std::round(units);
    if (whole >= 1.0 && std::abs(units - whole) <= 1e-15 * units * 4.0) {
      decimals_ = decimals;
      unit_ = unit;
      period_units_ = static_cast<std::int64_t>(whole);
      return;
    }
  }
}

char* TickClock::write(char* at, std::int64_t tick) const noexcept {
  if (period_units_ == 0) {
    return write_number<kMaxTimeDecimals>(at, static_cast<double>(tick) * period_s_);
  }
  const std::int64_t units = tick * period_units_;
  at = std::to_chars(at, at + kMaxNumberBytes, units / unit_).ptr;
  *at++ = '.';
  std::int64_t rest = units % unit_;
  for (int i = decimals_ - 1; i >= 0; --i, rest /= 10) {
    at[i] = static_cast<char>('0' + rest % 10);
  }
  return at + decimals_;
}

std::string trace_header(const TraceColumns& columns) {
  std::string header(kTraceHeader.substr(0, kTraceHeader.size() - 1));
  for (const ExtraAxis& axis : columns.axes) {
    header.append(",").append(axis.name).append("_").append(axis.unit);
  }
  return header + (columns.limit ? ",limit\n" : "\n");
}

char* write_row(char* at, const TickRecord& record, const TickClock& clock,
                const TraceColumns& columns) noexcept {
  at = clock.write(at, record.tick);
  *at++ = ',';
  at = std::to_chars(at, at + kMaxNumberBytes, record.line).ptr;
  *at++ = ',';
  at = write_number<kLengthDecimals>(at, record.motion.s_mm);
  for (const double value : {record.motion.v_mm_s, record.motion.a_mm_s2, record.motion.j_mm_s3}) {
    *at++ = ',';
    at = write_number<kMotionDecimals>(at, value);
  }
  for (const curves::Position* position : {&record.position_mm, &record.actual_mm}) {
    for (const double coordinate : *position) {
      *at++ = ',';
      at = write_number<kLengthDecimals>(at, coordinate);
    }
  }
  *at++ = ',';
  if (record.detail.curve_parameter) {
    at = write_number<kLengthDecimals>(at, *record.detail.curve_parameter);
  }
  *at++ = ',';
  at = write_number<kLengthDecimals>(at, record.detail.chord_error_mm);
  for (const ExtraAxis& axis : columns.axes) {
    *at++ = ',';
    at = write_number<kLengthDecimals>(at, axis.factor * record.extra_rad_mm[axis.index]);
  }
  if (columns.limit) {
    *at++ = ',';
    const std::string_view key = key_of(record.limit);
    at = std::copy(key.begin(), key.end(), at);
  }
  *at++ = '\n';
  return at;
}

}  // namespace kerf::program
