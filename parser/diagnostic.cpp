#include "parser/diagnostic.hpp"

namespace kerf::parser {

std::string to_string(const Diagnostic& diagnostic, std::string_view file) {
  std::string text(diagnostic.file.empty() ? file : std::string_view(diagnostic.file));
  text += ':' + std::to_string(diagnostic.source.line);
  text += ':' + std::to_string(diagnostic.source.column);
  text += diagnostic.severity == Severity::error ? ": error: " : ": warning: ";
  return text + diagnostic.message;
}

}  // namespace kerf::parser
