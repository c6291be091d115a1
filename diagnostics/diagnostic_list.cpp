#include "diagnostics/diagnostic_list.hpp"

#include <algorithm>

#include "diagnostics/errors/pages.hpp"

namespace kerf::diagnostics {

namespace {

constexpr std::size_t kMaxWarnings = 100;

}  // namespace

DiagnosticPlace DiagnosticList::place(SourcePosition source) const {
  source.file = file_;
  const bool known = source.line == line_ && source.column > 0;
  return {source, known ? excerpt_of(text_, source.column - 1) : Excerpt{}, file_name_};
}

void DiagnosticList::add(SourcePosition source, const ErrorPage& page, std::string message) {
  add_at(place(source), page, std::move(message));
}

// A loop runs into the same fault each time; it is said once.
bool DiagnosticList::known(const SourcePosition& source, std::string_view message) const {
  return std::any_of(list_.begin(), list_.end(), [&](const Diagnostic& one) {
    return one.source.line == source.line && one.source.column == source.column &&
           one.source.file == source.file && one.message == message;
  });
}

bool DiagnosticList::has(const ErrorPage& page, std::uint32_t line) const {
  return std::any_of(list_.begin(), list_.end(), [&](const Diagnostic& one) {
    return one.page == &page && one.source.line == line && one.source.file == file_;
  });
}

void DiagnosticList::add_at(DiagnosticPlace place, const ErrorPage& page, std::string message) {
  if (known(place.source, message)) {
    return;
  }
  if (page.severity == Severity::error) {
    if (!full()) {
      ++errors_;
      keep(std::move(place), page, std::move(message));
    }
    return;
  }
  if (warnings_ < kMaxWarnings) {
    keep(std::move(place), page, std::move(message));
  } else if (warnings_ == kMaxWarnings) {
    keep(std::move(place), errors::kTooManyWarnings,
         "more than 100 warnings: the rest is not shown");
  }
  warnings_ += warnings_ <= kMaxWarnings ? 1 : 0;
}

void DiagnosticList::keep(DiagnosticPlace place, const ErrorPage& page, std::string message) {
  Diagnostic& diagnostic = list_.emplace_back(place.source, page, std::move(message));
  diagnostic.file = place.file;
  diagnostic.block = std::move(place.block);
}

}  // namespace kerf::diagnostics
