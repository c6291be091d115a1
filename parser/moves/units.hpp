// The one place where the program's units become millimetres, seconds and mm/s.
#pragma once

#include <cstdint>

namespace kerf::parser {

enum class Units : std::uint8_t { mm, inch };  // G21, G20

constexpr double mm_per_unit(Units units) {
  return units == Units::inch ? 25.4 : 1.0;
}

// F of G94: program units per minute.
constexpr double feedrate_mm_s_from(double f_word, Units units) {
  return f_word * mm_per_unit(units) / 60.0;
}

inline constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

// F of G94 where A, B, C move alone: degrees per minute, whatever the unit of lengths.
constexpr double feedrate_rad_s_from(double f_word) {
  return f_word * kRadiansPerDegree / 60.0;
}

// F of G93: one over the minutes that the block takes.
struct InverseTime {
  double length_mm;
  double f_word_per_min;
};
constexpr double feedrate_mm_s_from(InverseTime block) {
  return block.length_mm * block.f_word_per_min / 60.0;
}

}  // namespace kerf::parser
