#include "diagnostics/diagnostic.hpp"

#include <algorithm>

namespace kerf {
inline namespace v0 {

std::string identifier(const ErrorPage& page) {
  constexpr std::size_t kDigits = 4;
  const std::string number = std::to_string(page.number);
  return 'E' + std::string(kDigits - std::min(kDigits, number.size()), '0') + number;
}

std::string to_string(const Diagnostic& diagnostic, std::string_view file) {
  std::string text(diagnostic.file.empty() ? file : diagnostic.file);
  text += ':' + std::to_string(diagnostic.source.line);
  text += ':' + std::to_string(diagnostic.source.column);
  text += diagnostic.severity == Severity::error ? ": error: " : ": warning: ";
  return text + diagnostic.message + " [" + identifier(*diagnostic.page) + ']';
}

std::string to_text(const Diagnostic& diagnostic, std::string_view file) {
  constexpr std::string_view kIndent = "    ";
  std::string text = to_string(diagnostic, file);
  const Excerpt& block = diagnostic.block;
  if (!block.text.empty()) {
    text.append("\n").append(kIndent).append(block.text);
    text.append("\n").append(kIndent).append(block.caret, ' ').append("^");
  }
  return text;
}

}  // namespace v0
}  // namespace kerf
