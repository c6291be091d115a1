// Calls of subprograms: what is asked for and where to go on afterwards.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace kerf::parser {

enum class CallKind : std::uint8_t {
  sub,      // o100 call: locals of its own, ends at endsub or return
  program,  // M98: shares its caller's locals, ends at M99
  macro,    // G65: locals of its own, ends at M99
  local,    // M97: as program, but begins at an N of the calling program (Haas)
};
constexpr bool has_own_locals(CallKind kind) {
  return kind == CallKind::sub || kind == CallKind::macro;
}

struct Call {
  CallKind kind = CallKind::sub;
  std::string label;          // plain, see plain_label()
  std::uint64_t runs = 1;     // > 0
  std::uint32_t line = 0;     // index of the calling line in its text
  std::uint32_t offset = 0;   // of the call in that line
  std::size_t arguments = 0;  // how many of the values are used
  std::array<double, 33> values{};
};

// M99 and its P.
struct Return {
  std::uint32_t offset = 0;         // in its line
  std::uint32_t line_number = 0;    // N to go on at in the calling program; 0: after the call
  std::uint32_t number_offset = 0;  // of P
};

}  // namespace kerf::parser
