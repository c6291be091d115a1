#include "programs/kerf/io/number_text.hpp"

#include <cmath>

#include <spdlog/fmt/fmt.h>

namespace kerf::program {

std::string short_number(double value) {
  if (std::abs(value) < 999'999.5 || !std::isfinite(value)) {
    return fmt::format("{:.6g}", value + 0.0);
  }
  const std::string digits = fmt::format("{:.2e}", value);
  const std::size_t e = digits.find('e');
  std::string mantissa = digits.substr(0, e);
  mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (mantissa.back() == '.') {
    mantissa.pop_back();
  }
  return fmt::format("{}e{}", mantissa, std::stoi(digits.substr(e + 1)));
}

std::string fixed_number(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') {
    text.erase(0, 1);
  }
  return text;
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
