#include "programs/kerf/compare/line_match.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "parser/text/line_splitter.hpp"

namespace kerf::program {

namespace {

using LineKeys = std::vector<std::size_t>;

// What a line says: without comments, blanks and N, in capitals. A slash before N stays.
std::string meaning_of(std::string_view line) {
  std::string text;
  bool comment = false;
  for (const char c : line) {
    comment = comment || c == '(';
    if (c == ';' && !comment) {
      break;
    }
    if (!comment && std::isspace(static_cast<unsigned char>(c)) == 0) {
      text.push_back(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
    }
    comment = comment && c != ')';
  }
  const auto behind_digits = [&text](std::size_t at) {
    while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0) {
      ++at;
    }
    return at;
  };
  const std::size_t number = text.starts_with('/') ? behind_digits(1) : 0;
  if (number < text.size() && text[number] == 'N' && behind_digits(number + 1) > number + 1) {
    text.erase(number, behind_digits(number + 1) - number);
  }
  return text;
}

// The same number for lines that say the same.
class Numbering {
 public:
  LineKeys keys_of(const std::vector<std::string>& lines) {
    LineKeys keys;
    keys.reserve(lines.size());
    for (const std::string& line : lines) {
      keys.push_back(numbers_.try_emplace(meaning_of(line), numbers_.size()).first->second);
    }
    return keys;
  }

 private:
  std::unordered_map<std::string, std::size_t> numbers_;
};

// Places in both programs, from 0.
struct Places {
  std::size_t first = 0;
  std::size_t second = 0;
};

// Up to `end` in each.
struct TextStretch {
  Places begin{};
  Places end{};
  int depth = 0;
};

class Matcher {
 public:
  Matcher(const LineKeys& first, const LineKeys& second) : first_(first), second_(second) {}

  // In ascending order.
  std::vector<Places> match() {
    std::vector<TextStretch> open{{.end = {first_.size(), second_.size()}}};
    while (!open.empty()) {
      TextStretch stretch = open.back();
      open.pop_back();
      take_ends(stretch);
      if (stretch.depth < kDeepest) {
        divide(stretch, open);
      }
    }
    std::sort(matched_.begin(), matched_.end(),
              [](const Places& a, const Places& b) { return a.first < b.first; });
    return std::move(matched_);
  }

 private:
  static constexpr int kDeepest = 64;

  static bool is_open(const TextStretch& stretch) {
    return stretch.begin.first < stretch.end.first && stretch.begin.second < stretch.end.second;
  }

  void take_ends(TextStretch& stretch) {
    while (is_open(stretch) && first_[stretch.begin.first] == second_[stretch.begin.second]) {
      matched_.push_back({stretch.begin.first++, stretch.begin.second++});
    }
    while (is_open(stretch) && first_[stretch.end.first - 1] == second_[stretch.end.second - 1]) {
      matched_.push_back({--stretch.end.first, --stretch.end.second});
    }
  }

  void divide(const TextStretch& stretch, std::vector<TextStretch>& open) {
    if (!is_open(stretch)) {
      return;
    }
    const std::vector<Places> anchors = longest_increasing(unique_in(stretch));
    Places begin = stretch.begin;
    for (const Places& anchor : anchors) {
      matched_.push_back(anchor);
      open.push_back({.begin = begin, .end = anchor, .depth = stretch.depth + 1});
      begin = {anchor.first + 1, anchor.second + 1};
    }
    if (!anchors.empty()) {
      open.push_back({.begin = begin, .end = stretch.end, .depth = stretch.depth + 1});
    }
  }

  // Lines that are once in both, in the order of the first program.
  [[nodiscard]] std::vector<Places> unique_in(const TextStretch& stretch) const {
    struct Found {
      Places at{};
      Places count{};
    };
    std::unordered_map<std::size_t, Found> found;
    for (std::size_t i = stretch.begin.first; i < stretch.end.first; ++i) {
      Found& line = found[first_[i]];
      line.at.first = i;
      ++line.count.first;
    }
    for (std::size_t i = stretch.begin.second; i < stretch.end.second; ++i) {
      Found& line = found[second_[i]];
      line.at.second = i;
      ++line.count.second;
    }
    std::vector<Places> unique;
    for (std::size_t i = stretch.begin.first; i < stretch.end.first; ++i) {
      const Found& line = found[first_[i]];
      if (line.count.first == 1 && line.count.second == 1) {
        unique.push_back(line.at);
      }
    }
    return unique;
  }

  // The most of them that stand in the same order in the second program.
  static std::vector<Places> longest_increasing(const std::vector<Places>& places) {
    std::vector<std::size_t> ends;  // of rows of 1, 2, ... places, each the lowest so far
    std::vector<std::size_t> before(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto end = std::lower_bound(
          ends.begin(), ends.end(), i,
          [&places](std::size_t a, std::size_t b) { return places[a].second < places[b].second; });
      before[i] = end == ends.begin() ? i : *std::prev(end);
      if (end == ends.end()) {
        ends.push_back(i);
      } else {
        *end = i;
      }
    }
    std::vector<Places> longest(ends.size());
    std::size_t at = ends.empty() ? 0 : ends.back();
    for (std::size_t k = ends.size(); k-- > 0; at = before[at]) {
      longest[k] = places[at];
    }
    return longest;
  }

  const LineKeys& first_;
  const LineKeys& second_;
  std::vector<Places> matched_;
};

LineSpan span_of(std::size_t begin, std::size_t end) {
  return {.first = static_cast<std::uint32_t>(begin + 1), .last = static_cast<std::uint32_t>(end)};
}

// What lies between two matched lines.
void add_between(const Places& begin, const Places& end, std::vector<MatchedLines>& pairs) {
  const std::size_t lines = end.first - begin.first;
  if (lines == end.second - begin.second) {
    for (std::size_t i = 0; i < lines; ++i) {
      pairs.push_back({.first = span_of(begin.first + i, begin.first + i + 1),
                       .second = span_of(begin.second + i, begin.second + i + 1)});
    }
    return;
  }
  pairs.push_back(
      {.first = span_of(begin.first, end.first), .second = span_of(begin.second, end.second)});
}

}  // namespace

std::vector<MatchedLines> match_lines(const std::vector<std::string>& first,
                                      const std::vector<std::string>& second) {
  Numbering numbering;
  const LineKeys first_keys = numbering.keys_of(first);
  const LineKeys second_keys = numbering.keys_of(second);
  std::vector<MatchedLines> pairs;
  Places begin;
  for (const Places& match : Matcher(first_keys, second_keys).match()) {
    add_between(begin, match, pairs);
    begin = {match.first + 1, match.second + 1};
    pairs.push_back({.first = span_of(match.first, begin.first),
                     .second = span_of(match.second, begin.second)});
  }
  add_between(begin, {first.size(), second.size()}, pairs);
  return pairs;
}

std::vector<std::string> lines_of(std::string_view text) {
  parser::LineSplitter splitter;
  splitter.feed(text);
  splitter.finish();
  std::vector<std::string> lines;
  for (parser::NumberedLine line; splitter.next(line);) {
    lines.emplace_back(line.text);
  }
  return lines;
}

}  // namespace kerf::program
