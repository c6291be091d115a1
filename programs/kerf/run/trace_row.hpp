// Ticks as lines of CSV.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "programs/kerf/report/extra_axes.hpp"
#include "programs/kerf/report/tick_record.hpp"

namespace kerf::program {

inline constexpr std::string_view kTraceHeader =
    "t_s,line,s_mm,v_mm_s,a_mm_s2,j_mm_s3,x_mm,y_mm,z_mm,actual_x_mm,actual_y_mm,actual_z_mm,u,"
    "chord_error_mm\n";
// Further columns of a row.
struct TraceColumns {
  std::vector<ExtraAxis> axes;  // "a_deg", "u_mm"
  bool limit = false;           // "limit": the active constraint
};
[[nodiscard]] std::string trace_header(const TraceColumns& columns);

// The time of a tick as decimal digits. Where the period is a whole number of 1e-6, 1e-7 .. 1e-12 s
// they are exact, however many ticks; else the nearest 1e-12 s.
class TickClock {
 public:
  explicit TickClock(double period_s) noexcept;

  // Writes the digits and returns their end. There is room: kMaxRowBytes.
  char* write(char* at, std::int64_t tick) const noexcept;

 private:
  double period_s_;
  int decimals_ = 12;
  std::int64_t unit_ = 1;          // 10^decimals_
  std::int64_t period_units_ = 0;  // 0: the period is no whole number of units
};

// No row is longer: 19 numbers of at most 309 + 1 + 10 digits and the time.
inline constexpr std::size_t kMaxRowBytes = 8192;

// Lengths and u with 10 decimals, v, a and j with 6; u is empty where the tick is on no NURBS; a
// decimal point whatever the locale. Returns the end of what was written at `at`, which has room
// for kMaxRowBytes.
char* write_row(char* at, const TickRecord& record, const TickClock& clock,
                const TraceColumns& columns = {}) noexcept;

}  // namespace kerf::program
