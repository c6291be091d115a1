// Collects diagnostics up to a limit, so that a hopeless file cannot fill the memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.hpp"

namespace kerf::diagnostics {

// A place in the text with what will be shown of it, for what turns out wrong only later.
struct DiagnosticPlace {
  SourcePosition source;
  Excerpt block;
  std::string_view file;
};

class DiagnosticList {
 public:
  explicit DiagnosticList(std::size_t max_errors) : max_errors_(max_errors) {}

  // An error or a warning, as its page says. Each kind has a limit; the last warning says that
  // there are more.
  void add(SourcePosition source, const ErrorPage& page, std::string message);

  void add_at(DiagnosticPlace place, const ErrorPage& page, std::string message);
  // The place as it is known now, while its line is being read.
  [[nodiscard]] DiagnosticPlace place(SourcePosition source) const;

  // The line that is being read: its text goes with what is said about it, also once more text was
  // fed, as of a probe that is answered later.
  void at_line(std::uint32_t number, std::string_view text) {
    line_ = number;
    text_ = text;
  }

  // What follows is about a subprogram's file, or with index 0 about the program again.
  // `name` must outlive the list's use.
  void enter_file(std::uint16_t index, std::string_view name) {
    file_ = index;
    file_name_ = name;
  }

  // Whether the page was given for this line of the text that is being read.
  [[nodiscard]] bool has(const ErrorPage& page, std::uint32_t line) const;
  [[nodiscard]] bool full() const { return errors_ >= max_errors_; }
  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] const std::vector<Diagnostic>& all() const { return list_; }

 private:
  [[nodiscard]] bool known(const SourcePosition& source, std::string_view message) const;
  void keep(DiagnosticPlace place, const ErrorPage& page, std::string message);

  std::vector<Diagnostic> list_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
  std::size_t max_errors_;
  std::uint16_t file_ = 0;
  std::string_view file_name_;
  std::uint32_t line_ = 0;
  std::string text_;
};

}  // namespace kerf::diagnostics
