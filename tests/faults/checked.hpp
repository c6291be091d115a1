// A program as `kerf check` sees it, and what is said of it.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/check.hpp>

#include "diagnostics/diagnostic.hpp"
#include "parser/program_reader.hpp"

namespace kerf::faults {

inline CheckReport check(std::string_view text, const KernelOptions& options = {},
                         const MachineSettings& settings = {}) {
  bool given = false;
  return check_program(
      [&]() -> std::string_view {
        const bool first = !given;
        given = true;
        return first ? text : std::string_view{};
      },
      settings, options);
}

// All messages, one a line: `line:column: error: text [E0123]`.
inline std::string said_of(std::string_view text, const KernelOptions& options = {},
                           const MachineSettings& settings = {}) {
  std::string lines;
  for (const diagnostics::Diagnostic& diagnostic : check(text, options, settings).diagnostics) {
    lines += to_string(diagnostic, "").substr(1) + "\n";
  }
  return lines;
}

// With an end after it, so that nothing is said of a missing one.
inline std::string said_of_block(const std::string& text) {
  return said_of(text + "\nM2\n");
}

// Of a program without errors.
inline std::vector<parser::Move> moves_of(std::string_view text) {
  parser::ProgramReader reader;
  reader.feed(text);
  reader.finish();
  std::vector<parser::Move> moves;
  for (parser::Move move; reader.next(move);) {
    moves.push_back(move);
  }
  EXPECT_FALSE(reader.has_errors()) << reader.diagnostics().front().message;
  return moves;
}

// Precondition: a line.
inline double x_of(const parser::Move& move) {
  return std::get<parser::LineMove>(move.shape).end_mm[0];
}

inline testing::AssertionResult says(std::string_view said, std::string_view part) {
  return said.find(part) != std::string_view::npos ? testing::AssertionSuccess()
                                                   : testing::AssertionFailure()
                                                         << "'" << part << "' is not in\n"
                                                         << said;
}

}  // namespace kerf::faults
