#include <kerf/program_data.hpp>

namespace kerf {
inline namespace v0 {

ProgramData default_program_data() {
  constexpr std::int32_t kPlaces = 60;
  ProgramData data;
  data.tools.set_given();
  for (std::int32_t number = 1; number <= kPlaces; ++number) {
    data.tools.put({.number = number, .pocket = number});
  }
  data.tools.put({.number = 1, .pocket = 1, .offset_mm = {0.0, 0.0, 12.5}, .diameter_mm = 10.0});
  data.tools.put({.number = 2, .pocket = 2, .diameter_mm = 6.0});
  data.tools.put({.number = 3, .pocket = 3, .offset_mm = {0.0, 0.0, -3.0}, .diameter_mm = 20.0});
  return data;
}

}  // namespace v0
}  // namespace kerf
