#include "diagnostics/errors/pages.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace kerf::errors {

// The texts are read here only, so that they cost the compiler nothing where a page is given.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the list is written once.
#define ERROR_PAGE(name, number, severity, ...) \
  constexpr ErrorPage name{number, Severity::severity, __VA_ARGS__};
#include "diagnostics/errors/pages.def"
#undef ERROR_PAGE

namespace {

constexpr auto kPages = std::to_array<const ErrorPage*>({
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): as above.
#define ERROR_PAGE(name, ...) &name,
#include "diagnostics/errors/pages.def"
#undef ERROR_PAGE
});

constexpr bool numbers_rise() {
  return std::ranges::adjacent_find(kPages, std::greater_equal{}, &ErrorPage::number) ==
         kPages.end();
}
static_assert(numbers_rise(), "a page's number is greater than that of the page before it");
static_assert(kPages.front()->number > 0 && kPages.back()->number < 10'000, "E0001 to E9999");

// Titles are a few words, the texts sentences.
constexpr bool is_complete(const ErrorPage* page) {
  return !page->title.empty() && !page->title.ends_with('.') && page->meaning.ends_with('.') &&
         page->remedy.ends_with('.') && (!page->trigger.empty() || page->more.times > 0);
}
static_assert(std::ranges::all_of(kPages, is_complete));

}  // namespace

std::span<const ErrorPage* const> catalogue() {
  return kPages;
}

const ErrorPage* find_page(std::uint16_t number) {
  const auto* const found = std::ranges::lower_bound(kPages, number, {}, &ErrorPage::number);
  return found == kPages.end() || (*found)->number != number ? nullptr : *found;
}

std::string trigger_of(const ErrorPage& page) {
  std::string text(page.trigger);
  const std::string_view more = page.more.text;
  const std::size_t counter = more.find('@');
  for (std::uint32_t i = 1; i <= page.more.times; ++i) {
    text += more.substr(0, counter);
    if (counter != std::string_view::npos) {
      text.append(std::to_string(i)).append(more.substr(counter + 1));
    }
  }
  return text;
}

}  // namespace kerf::errors
