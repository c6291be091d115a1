#include "programs/kerf/cli/error_page_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <iterator>

#include <spdlog/fmt/fmt.h>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/errors/pages.hpp"
#include "programs/kerf/io/visible_text.hpp"

namespace kerf::program {

namespace {

using diagnostics::ErrorPage;

struct Chapter {
  std::uint16_t first;
  std::string_view title;
};
constexpr std::array kChapters{Chapter{1, "Text and numbers"},
                               Chapter{100, "Blocks and codes"},
                               Chapter{200, "Motion and arcs"},
                               Chapter{300, "NURBS and splines"},
                               Chapter{400, "Expressions and parameters"},
                               Chapter{500, "Flow and subprograms"},
                               Chapter{600, "Offsets, tools and the machine's switches"},
                               Chapter{700, "Cutter compensation"},
                               Chapter{800, "Cycles, probing and spindle modes"},
                               Chapter{900, "Fanuc dialect"},
                               Chapter{1000, "The machine"}};

constexpr std::string_view kPreamble =
    R"(# Errors and warnings

`kerf errors --markdown` writes this file from the code; a test holds it against a fresh one. `kerf errors E0120` prints one page.

A message has the form

    part.ngc:2:8: error: F must not be negative [E0120]
        G1 X10 F-100
               ^

An error stops a program before anything moves; a warning does not. Up to 100 errors are shown. Numbers keep their meaning: a page that
is dropped leaves its number unused. The program under each page is one that gives its message.
)";

std::string_view kind_of(const ErrorPage& page) {
  return page.severity == diagnostics::Severity::error ? "error" : "warning";
}

// A trigger with its invisible bytes written as \xFF.
std::string visible_lines(std::string_view trigger) {
  std::string text;
  for (std::size_t end = 0; (end = trigger.find('\n')) != std::string_view::npos;) {
    text += visible(trigger.substr(0, end)) + '\n';
    trigger.remove_prefix(end + 1);
  }
  return text + visible(trigger);
}

// What the trigger goes on with, as far as it need be shown.
std::string more_of(const kerf::Repeated& more) {
  if (more.text.find_first_not_of(' ') == std::string_view::npos) {
    return fmt::format("({} blanks)\n", more.times);
  }
  std::string text = visible_lines(more.text);
  const std::size_t counter = text.find('@');
  if (counter != std::string::npos) {
    text.replace(counter, 1, "1");
  }
  return fmt::format("{}... ({} of these{})\n", text, more.times,
                     counter == std::string::npos ? "" : ", counted on");
}

std::string example_of(const ErrorPage& page) {
  return visible_lines(page.trigger) + (page.more.times > 0 ? more_of(page.more) : std::string());
}

std::string indented(std::string_view text, std::string_view indent) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    out.append(indent).append(text.substr(0, length)).append("\n");
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return out;
}

// Lines of at most `width` bytes, broken at blanks.
std::string wrapped(std::string_view text, std::size_t width) {
  std::string out;
  while (text.size() > width) {
    const std::size_t blank = text.rfind(' ', width);
    const std::size_t length = blank == std::string_view::npos ? text.find(' ') : blank;
    if (length == std::string_view::npos) {
      break;
    }
    out.append(text.substr(0, length)).append("\n");
    text.remove_prefix(length + 1);
  }
  return out.append(text).append("\n");
}

std::string dialect_note(const ErrorPage& page) {
  return page.dialect.empty() ? "" : fmt::format(" with --dialect {}", page.dialect);
}

}  // namespace

std::string error_page_list() {
  std::string text;
  for (const ErrorPage* page : errors::catalogue()) {
    fmt::format_to(std::back_inserter(text), "{}  {:<7}  {}\n", diagnostics::identifier(*page),
                   kind_of(*page), page->title);
  }
  return text;
}

tl::expected<std::string, std::string> error_page_text(std::string_view identifier) {
  std::string_view digits = identifier;
  if (!digits.empty() && (digits.front() == 'E' || digits.front() == 'e')) {
    digits.remove_prefix(1);
  }
  std::uint16_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto read = std::from_chars(digits.data(), end, number);
  const bool is_number = read.ec == std::errc{} && read.ptr == end;
  const ErrorPage* const page = is_number ? errors::find_page(number) : nullptr;
  if (page == nullptr) {
    return tl::unexpected(fmt::format("there is no page {} (kerf errors lists them)", identifier));
  }
  constexpr std::size_t kWidth = 88;
  return fmt::format("{}: {}: {}\n\n{}\n{}\nA program with it{}:\n\n{}",
                     diagnostics::identifier(*page), kind_of(*page), page->title,
                     wrapped(page->meaning, kWidth), wrapped(page->remedy, kWidth),
                     dialect_note(*page), indented(example_of(*page), "    "));
}

std::string error_pages_markdown() {
  std::string text(kPreamble);
  const auto* chapter = kChapters.begin();
  for (const ErrorPage* page : errors::catalogue()) {
    while (chapter != kChapters.end() && page->number >= chapter->first) {
      if (std::next(chapter) == kChapters.end() || page->number < std::next(chapter)->first) {
        fmt::format_to(std::back_inserter(text), "\n## {}\n", chapter->title);
      }
      ++chapter;
    }
    fmt::format_to(std::back_inserter(text), "\n### {}: {}\n\n*{}.* {}\n\n*To mend it:* {}\n\n{}",
                   diagnostics::identifier(*page), page->title,
                   page->severity == diagnostics::Severity::error ? "Error" : "Warning",
                   page->meaning, page->remedy, indented(example_of(*page), "    "));
    if (!dialect_note(*page).empty()) {
      fmt::format_to(std::back_inserter(text), "\n({})\n", dialect_note(*page).substr(1));
    }
  }
  return text;
}

}  // namespace kerf::program
