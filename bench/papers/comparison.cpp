#include "bench/papers/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace kerf::bench {

namespace {

double tolerance_of(const PaperFigure& figure) {
  return figure.tolerance > 0.0 ? figure.tolerance : std::pow(10.0, -figure.decimals);
}

std::string_view standing_of(const PaperFigure& figure) {
  const double apart = std::abs(figure.here - figure.published);
  if (apart <= tolerance_of(figure) * (1.0 + 1e-9)) {
    return "reproduced";
  }
  const bool is_in_band = apart <= figure.band;  // a figure that is no number is not
  if (!is_in_band || figure.why.empty()) {
    return "BROKEN";
  }
  return figure.impossible ? "impossible" : "approached";
}

std::string shortest(double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

// How far apart the two may be, where that is not one of the last digit.
std::string band_of(const PaperFigure& figure, bool is_reproduced) {
  const double band = is_reproduced ? figure.tolerance : figure.band;
  return band > 0.0 ? shortest(band) : "";
}

}  // namespace

std::string fixed(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

void Comparison::add(const PaperFigure& figure) {
  const std::string_view standing = standing_of(figure);
  const std::string here = fixed(figure.here, figure.decimals);
  if (standing == "BROKEN") {
    broken_.push_back(figure.name + ": " + here + " is farther from " +
                      fixed(figure.published, figure.decimals) + " than " +
                      shortest(std::max(tolerance_of(figure), figure.band)) +
                      (figure.why.empty() ? ", or nothing says why they are apart" : ""));
  }
  rows_.push_back("| " + figure.name + " | " + fixed(figure.published, figure.decimals) + " | " +
                  here + " | " + std::string(standing) + " | " +
                  band_of(figure, standing == "reproduced") + " | " + figure.why + " |");
}

void Comparison::require(std::string_view what, bool holds) {
  if (!holds) {
    broken_.emplace_back(what);
  }
}

void Comparison::print(std::string_view heading) const {
  std::printf(
      "%.*s\n\n| figure | published | here | | band | why |\n| --- | --- | --- | --- | --- | --- "
      "|\n",
      static_cast<int>(heading.size()), heading.data());
  for (const std::string& row : rows_) {
    std::printf("%s\n", row.c_str());
  }
  std::printf("\n");
}

bool Comparison::judge() const {
  for (const std::string& broken : broken_) {
    std::printf("BROKEN: %s\n\n", broken.c_str());
  }
  return broken_.empty();
}

}  // namespace kerf::bench
