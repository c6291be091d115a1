// Programs with flow: where the tool goes, what is said, and subprograms in files.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "tests/parser/program.hpp"

namespace kerf::parser {

// Messages of the whole program, one a line, `line:column: error: ...`; of a file with its name.
inline std::string messages_of(std::string_view text, const ReaderOptions& options = {}) {
  std::string result;
  for (const diagnostics::Diagnostic& diagnostic : read_program(text, options).diagnostics) {
    const std::string line = to_string(diagnostic, "");
    const std::string_view shown = std::string_view(line).substr(line[0] == ':' ? 1 : 0);
    result += shown.substr(0, shown.rfind(" [E"));
    result += '\n';
  }
  return result;
}

// The X coordinates that a program free of errors goes to, M2 added.
inline std::string path_of(const std::string& text, const ReaderOptions& options = {}) {
  const Program program = read_program(text + "\nM2\n", options);
  std::string result = program.has_errors ? to_string(program.diagnostics.front(), "") : "";
  for (const Move& move : program.moves) {
    if (const auto* line = std::get_if<LineMove>(&move.shape)) {
      result += (result.empty() ? "" : " ") +
                text_of(line->end_mm).substr(0, text_of(line->end_mm).find(' '));
    }
  }
  return result;
}

inline ReaderOptions with_files(const std::map<std::string, std::string>& files) {
  ReaderOptions options;
  options.subprograms = [files](std::string_view name) -> std::optional<SubprogramText> {
    const auto found = files.find(std::string(name));
    if (found == files.end()) {
      return std::nullopt;
    }
    return SubprogramText{found->first + ".ngc", found->second};
  };
  return options;
}

// Moves and messages, for comparing.
inline std::string everything(const Program& program) {
  std::string text;
  for (const Move& move : program.moves) {
    text += text_of(move) + " from " + text_of(move.start_mm) + " at " +
            std::to_string(move.source.column) + '\n';
  }
  for (const diagnostics::Diagnostic& diagnostic : program.diagnostics) {
    text += to_text(diagnostic, "p") + '\n';
  }
  return text + (program.at_end ? "end" : "open");
}

}  // namespace kerf::parser
