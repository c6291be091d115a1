// A machine for a program's probes where none is asked.
#pragma once

#include <optional>

#include "parser/modal/machine_source.hpp"

namespace kerf::parser {

// The top of a table at Z-150, for ways along Z; inputs are low.
class TableTop final : public AssumedMachine {
 public:
  [[nodiscard]] bool has_surface() const override { return true; }
  [[nodiscard]] bool touches(const ProbedWay& way) const override {
    return way.from_mm[2] <= kTop_mm;
  }
  [[nodiscard]] std::optional<Point> change_of_contact(const ProbedWay& way) const override {
    const bool changes = (way.from_mm[2] <= kTop_mm) != (way.to_mm[2] <= kTop_mm);
    return changes ? std::optional(Point{way.to_mm[0], way.to_mm[1], kTop_mm}) : std::nullopt;
  }
  [[nodiscard]] bool digital(std::size_t /*input*/) const override { return false; }
  [[nodiscard]] double analog(std::size_t /*input*/) const override { return 0.0; }
  [[nodiscard]] double spindle_time_s(double /*from_per_min*/,
                                      double /*to_per_min*/) const override {
    return 0.0;
  }

 private:
  static constexpr double kTop_mm = -150.0;
};

}  // namespace kerf::parser
