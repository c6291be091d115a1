// Collects diagnostics up to a limit, so that a hopeless file cannot fill the memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/diagnostic.hpp"

namespace kerf::parser {

class DiagnosticList {
 public:
  explicit DiagnosticList(std::size_t max_errors) : max_errors_(max_errors) {}

  void error(SourcePosition source, std::string message, const ErrorPage* page = nullptr) {
    if (!full()) {
      ++errors_;
      add(Severity::error, source, std::move(message), page);
    }
  }

  // Warnings have a limit of their own; the last one says that there are more.
  void warning(SourcePosition source, std::string message, const ErrorPage* page = nullptr) {
    constexpr std::size_t kMaxWarnings = 100;
    if (warnings_ > kMaxWarnings) {
      return;
    }
    if (warnings_++ == kMaxWarnings) {
      message = "more than 100 warnings: the rest is not shown";
    }
    add(Severity::warning, source, std::move(message), page);
  }

  // An error or a warning, as its page says.
  void add(SourcePosition source, const ErrorPage& page, std::string message) {
    if (page.severity == Severity::error) {
      error(source, std::move(message), &page);
    } else {
      warning(source, std::move(message), &page);
    }
  }

  // What follows is about a subprogram's file, or with index 0 about the program again.
  // `name` must outlive the list's use.
  void enter_file(std::uint16_t index, std::string_view name) {
    file_ = index;
    file_name_ = name;
  }

  [[nodiscard]] bool full() const { return errors_ >= max_errors_; }
  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return list_; }

 private:
  void add(Severity severity, SourcePosition source, std::string message, const ErrorPage* page) {
    source.file = file_;
    list_.push_back({severity, source, std::move(message), page, std::string(file_name_)});
  }

  std::vector<Diagnostic> list_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  std::size_t max_errors_;
  std::uint16_t file_ = 0;
  std::string_view file_name_;
};

}  // namespace kerf::parser
