#include "programs/number_text.hpp"

#include <cmath>

#include <spdlog/fmt/fmt.h>

namespace kerf::program {

std::string short_number(double value) {
  if (std::abs(value) < 999'999.5 || !std::isfinite(value)) {
    return fmt::format("{:.6g}", value + 0.0);
  }
  const std::string digits = fmt::format("{:.2e}", value);
  const std::size_t e = digits.find('e');
  return fmt::format("{}e{}", digits.substr(0, e), std::stoi(digits.substr(e + 1)));
}

std::string clock_time(double duration_s) {
  if (!(duration_s >= 0.0) || duration_s > 1e12) {
    return "-";
  }
  const long long ms = std::llround(duration_s * 1000.0);
  return fmt::format("{}:{:02}:{:02}.{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60,
                     ms % 1000);
}

std::string counted(unsigned long long count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace kerf::program
