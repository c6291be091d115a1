// The program's bytes as lines, with what can be wrong with the file as a whole.
#pragma once

#include <optional>
#include <string_view>

#include "diagnostics/diagnostic_list.hpp"
#include "parser/text/line_splitter.hpp"

namespace kerf::parser {

class ProgramInput {
 public:
  // The list must outlive the input.
  explicit ProgramInput(diagnostics::DiagnosticList& diagnostics) : diagnostics_(&diagnostics) {}

  void feed(std::string_view bytes) { lines_.feed(bytes); }
  void finish() { lines_.finish(); }

  // False: feed more, or the end, or the file was refused as no part program.
  bool next(NumberedLine& line) {
    if (refused_ || !lines_.next(line)) {
      return false;
    }
    if (end_mark_ || (!line.text.empty() && line.text.back() == kEndMark)) {
      take_end_mark(line);
    }
    return line.number > 1 || accept_first(line);
  }
  // The program has ended: the rest of the text is not checked.
  void pass_over() { passes_over_ = true; }
  [[nodiscard]] bool refused() const { return refused_; }
  [[nodiscard]] bool finished() const { return refused_ || lines_.finished(); }
  // How many lines there were so far.
  [[nodiscard]] std::uint32_t lines() const { return lines_.lines(); }

 private:
  static constexpr char kEndMark = '\x1A';  // Ctrl-Z, as CP/M and DOS end a text

  bool accept_first(NumberedLine& line);
  void take_end_mark(NumberedLine& line);

  LineSplitter lines_;
  diagnostics::DiagnosticList* diagnostics_;
  std::optional<diagnostics::DiagnosticPlace> end_mark_;  // where one stands
  bool passes_over_ = false;
  bool refused_ = false;
};

}  // namespace kerf::parser
