#include "parser/diagnostic_list.hpp"

#include "parser/errors/files.hpp"

namespace kerf::parser {

namespace {

constexpr std::size_t kMaxWarnings = 100;

}  // namespace

void DiagnosticList::add(SourcePosition source, const ErrorPage& page, std::string message) {
  if (page.severity == Severity::error) {
    if (!full()) {
      ++errors_;
      keep(source, page, std::move(message));
    }
    return;
  }
  if (warnings_ < kMaxWarnings) {
    keep(source, page, std::move(message));
  } else if (warnings_ == kMaxWarnings) {
    keep(source, errors::kTooManyWarnings, "more than 100 warnings: the rest is not shown");
  }
  warnings_ += warnings_ <= kMaxWarnings ? 1 : 0;
}

void DiagnosticList::keep(SourcePosition source, const ErrorPage& page, std::string message) {
  source.file = file_;
  Diagnostic& diagnostic = list_.emplace_back(source, page, std::move(message));
  diagnostic.file = file_name_;
  if (source.line == line_ && source.column > 0) {
    diagnostic.block = excerpt_of(text_, source.column - 1);
  }
}

}  // namespace kerf::parser
