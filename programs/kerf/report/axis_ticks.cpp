#include "programs/kerf/report/axis_ticks.hpp"

#include <cmath>

namespace kerf::program {

double round_down(double value) noexcept {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {10.0, 5.0, 2.0}) {
    if (factor * decade <= value * (1.0 + 1e-9)) {
      return factor * decade;
    }
  }
  return decade;
}

std::vector<double> axis_ticks(const ValueRange& range, int count) {
  if (!(range.width() > 0.0) || !std::isfinite(range.width()) || count < 1) {
    return {};
  }
  const double wanted = range.width() / count;
  double step = round_down(wanted);
  // Of the two round numbers around the wanted step the upper one, unless the lower one is all but
  // it.
  if (step < wanted * 0.999) {
    step = round_down(step * 2.5);
  }
  std::vector<double> ticks;
  const double slack = 1e-9 * range.width();
  const double first = std::ceil((range.min - slack) / step);
  const double last = std::floor((range.max + slack) / step);
  const auto more =
      static_cast<int>(last - first);  // one number of a step fits count times at most
  for (int i = 0; i <= more; ++i) {
    ticks.push_back((first + i) * step + 0.0);
  }
  return ticks;
}

}  // namespace kerf::program
