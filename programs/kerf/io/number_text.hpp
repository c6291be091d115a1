// Numbers for people, the same in every locale.
#pragma once

#include <string>

namespace kerf::program {

// Six digits below a million ("54999.8", "0.00123"), "1.24e6" from there on.
[[nodiscard]] std::string short_number(double value);

// "-12.340"; never "-0.000".
[[nodiscard]] std::string fixed_number(double value, int decimals);

// "1:02:03.004": hours, minutes, seconds, milliseconds (rounded). Negative or not a number: "-".
[[nodiscard]] std::string clock_time(double duration_s);

// "1 block", "2 blocks".
[[nodiscard]] std::string counted(unsigned long long count, const std::string& noun);

}  // namespace kerf::program
