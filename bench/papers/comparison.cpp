#include "bench/papers/comparison.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace kerf::bench {

namespace {

std::string_view standing_of(const PaperFigure& figure) {
  const double apart = std::abs(figure.here - figure.published);
  const double last_digit = std::pow(10.0, -figure.decimals);
  const double tolerance = figure.tolerance > 0.0 ? figure.tolerance : last_digit;
  if (apart <= tolerance * (1.0 + 1e-9)) {
    return "reproduced";
  }
  if (apart > figure.band || figure.why.empty()) {
    return "BROKEN";
  }
  return figure.impossible ? "impossible" : "approached";
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
    broken_.push_back(figure.name + ": " + here + " is farther from the published one than " +
                      fixed(figure.band, figure.decimals));
  }
  rows_.push_back("| " + figure.name + " | " + fixed(figure.published, figure.decimals) + " | " +
                  here + " | " + std::string(standing) + " | " + figure.why + " |");
}

void Comparison::require(std::string_view what, bool holds) {
  if (!holds) {
    broken_.emplace_back(what);
  }
}

void Comparison::print(std::string_view heading) const {
  std::printf("%.*s\n\n| figure | published | here | | why |\n| --- | --- | --- | --- | --- |\n",
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
