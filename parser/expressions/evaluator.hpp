// Values of words: numbers, variables and expressions, worked out while they are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic_list.hpp"
#include "diagnostics/fault.hpp"
#include "parser/expressions/expression_grammar.hpp"
#include "parser/expressions/parameters.hpp"

namespace kerf::parser {

// How far from a whole number the number of a variable or a label may be [rs274: 5.00005 is #5,
// 5.001 is refused].
inline constexpr double kWholeTolerance = 1e-4;

// A place in a line.
struct Cursor {
  std::string_view line;
  std::size_t at = 0;

  [[nodiscard]] const char* position() const { return line.data() + at; }
  [[nodiscard]] const char* end() const { return line.data() + line.size(); }
};

// Reads values at a cursor, which it moves after them. A value is finite or, in Fanuc's dialect,
// kVacant. Angles are in degrees, lengths in the program's units.
//
//   value       number | [sign] ('[' expression ']' | variable | function)
//   variable    '#' (value | '<' name '>')
//   assignment  variable '=' value; Fanuc: variable '=' expression
//
// The first fault of a line is kept; it points at the very character. Nesting deeper than
// kMaxDepth is a fault, so that no text can overflow the stack.
class Evaluator {
 public:
  static constexpr int kMaxDepth = 64;

  // The parameters must outlive the evaluator.
  explicit Evaluator(Parameters& parameters) : parameters_(&parameters) {}

  [[nodiscard]] Parameters& parameters() const { return *parameters_; }
  [[nodiscard]] Dialect dialect() const { return parameters_->dialect(); }

  // Forgets the fault and the assignments of the line before.
  void begin_line() {
    if (used_) {
      reset();
    }
  }
  // False: see fault(). Blanks after the value are not taken.
  bool read_value(Cursor& cursor, double& value);
  // The same without brackets around it: what stands after Fanuc's '='.
  bool read_expression(Cursor& cursor, double& value);
  // `#1=2`. RS274/NGC: the parameter changes at commit(), so that every value of the line is from
  // before it. Fanuc: it changes at once.
  bool read_assignment(Cursor& cursor);
  // Whether a value can begin at `cursor`: told by one character or a function's name.
  [[nodiscard]] bool value_begins(const Cursor& cursor) const;
  // Does what the line's assignments say.
  void commit();

  [[nodiscard]] const diagnostics::Fault& fault() const { return fault_; }
  // Offset + 1 of a variable that was read after its assignment in the same line, where it still
  // had the value from before; 0: none.
  [[nodiscard]] std::uint32_t stale_read() const { return stale_read_; }

  // The first numbered variable of the line that was read though nothing had set it; told once.
  struct UnsetRead {
    int number = 0;
    std::uint32_t offset = 0;
  };
  std::optional<UnsetRead> take_unset_read() { return std::exchange(unset_read_, std::nullopt); }

  // Where the value that was read last calls ROUND; null: it does not.
  [[nodiscard]] const char* rounding() const { return rounding_; }

  // For the grammar. Keeps the first fault of the line; returns false.
  bool fail(const char* at, const diagnostics::ErrorPage& page, std::string message);
  [[nodiscard]] bool failed() const { return failed_; }
  bool read(const Reference& variable, double& value);
  [[nodiscard]] bool exists(const Reference& variable) const;
  void note_rounding(const char* at) { rounding_ = at; }
  bool enter(const char* at);
  void leave() { --depth_; }

 private:
  struct Pending {
    int number = 0;  // 0: by name
    std::string_view name;
    double value = 0.0;
  };

  void reset();
  void begin(const Cursor& cursor);
  [[nodiscard]] bool is_pending(const Reference& variable) const;
  bool find_number(const Reference& variable, int& number);
  bool check_writable(const Reference& variable, int& number);
  bool fail_reading(const Reference& variable, int number);

  Parameters* parameters_;
  std::vector<Pending> pending_;
  diagnostics::Fault fault_;
  std::string_view line_;
  int depth_ = 0;
  bool used_ = false;  // something below or above is of this line
  bool failed_ = false;
  std::uint32_t stale_read_ = 0;
  std::optional<UnsetRead> unset_read_;
  const char* rounding_ = nullptr;
};

// A variable that counts as 0 because nothing has set it. Once in a line, which may read another
// one in each turn of a loop.
void warn_of_unset(const Evaluator::UnsetRead& read, std::uint32_t line,
                   diagnostics::DiagnosticList& diagnostics);

}  // namespace kerf::parser
