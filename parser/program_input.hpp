// The program's bytes as lines, with what can be wrong with the file as a whole.
#pragma once

#include <string_view>

#include "parser/diagnostic_list.hpp"
#include "parser/line_splitter.hpp"

namespace kerf::parser {

class ProgramInput {
 public:
  // The list must outlive the input.
  explicit ProgramInput(DiagnosticList& diagnostics) : diagnostics_(&diagnostics) {}

  void feed(std::string_view bytes) { lines_.feed(bytes); }
  void finish() { lines_.finish(); }

  // False: feed more, or the end, or the file was refused as no part program.
  bool next(Line& line) {
    return !refused_ && lines_.next(line) && (line.number > 1 || accept_first(line));
  }
  [[nodiscard]] bool refused() const { return refused_; }
  [[nodiscard]] bool finished() const { return refused_ || lines_.finished(); }
  // How many lines there were so far.
  [[nodiscard]] std::uint32_t lines() const { return lines_.lines(); }

 private:
  bool accept_first(Line& line);

  LineSplitter lines_;
  DiagnosticList* diagnostics_;
  bool refused_ = false;
};

}  // namespace kerf::parser
