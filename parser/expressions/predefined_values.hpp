// Parameters that belong to the machine's state rather than to the program.
#pragma once

#include <optional>
#include <string_view>

namespace kerf::parser {

// Fulfilled by the interpreter. The program reads these as #5420 or #<_feed>; it is asked anew at
// each use, so the values are always those of the block that reads them.
class PredefinedValues {
 public:
  PredefinedValues() = default;
  PredefinedValues(const PredefinedValues&) = default;
  PredefinedValues& operator=(const PredefinedValues&) = default;
  virtual ~PredefinedValues() = default;

  // The value of parameter `number`, in the program's units. Nothing: an ordinary parameter.
  [[nodiscard]] virtual std::optional<double> number(int number) const = 0;
  // `name` is lower case, without blanks and without #< >. Nothing: no predefined name. All
  // predefined names are read-only.
  [[nodiscard]] virtual std::optional<double> name(std::string_view name) const = 0;
  // The program writes parameter `number`. False: nobody here keeps it, so the parameters will.
  virtual bool take(int number, double value) = 0;
};

}  // namespace kerf::parser
