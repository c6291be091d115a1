#include "programs/kerf/report/time_parts.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace kerf::program {

namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_space(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view without_number(std::string_view line) {
  if (line.size() < 2 || (line[0] != 'N' && line[0] != 'n') || !is_digit(line[1])) {
    return line;
  }
  line.remove_prefix(1);
  while (!line.empty() && is_digit(line.front())) {
    line.remove_prefix(1);
  }
  return trimmed(line);
}

std::string_view comment_of(std::string_view line) {
  if (line.starts_with(';')) {
    return trimmed(line.substr(1));
  }
  const bool is_one = line.starts_with('(') && line.find_first_of("()", 1) == line.size() - 1 &&
                      line.ends_with(')');
  return is_one ? trimmed(line.substr(1, line.size() - 2)) : std::string_view();
}

bool is_acted_on(std::string_view words) {
  constexpr std::array<std::string_view, 10> kWords{
      "msg",       "print",    "debug",     "log",        "logopen",
      "logappend", "logclose", "probeopen", "probeclose", "abort"};
  const std::size_t comma = words.find(',');
  if (comma == std::string_view::npos) {
    return false;
  }
  std::string first(trimmed(words.substr(0, comma)));
  std::transform(first.begin(), first.end(), first.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return std::ranges::find(kWords, first) != kWords.end();
}

std::int64_t TimeSplit::*kind_in_motion(const TickRecord& record) {
  return kind_of(record) == TickKind::rapid ? &TimeSplit::rapid : &TimeSplit::cutting;
}

void add_up(TimeSplit& all, const TimeSplit& part) {
  for (const auto kind :
       {&TimeSplit::cutting, &TimeSplit::rapid, &TimeSplit::rest, &TimeSplit::tool_change}) {
    all.*kind += part.*kind;
  }
}

void append(std::vector<TimePart>& parts, TimePart part) {
  if (part.ticks() > 0) {
    parts.push_back(std::move(part));
  }
}

}  // namespace

std::string heading_of(std::string_view line) {
  const std::string_view words = comment_of(without_number(trimmed(line)));
  return is_acted_on(words) ? std::string() : std::string(words);
}

void PartsAccount::count(const Place& place, std::int64_t TimeSplit::*kind, std::int64_t ticks) {
  if (of_counted_ == nullptr || !(place == counted_)) {
    counted_ = place;
    of_counted_ = &places_[place];
  }
  of_counted_->*kind += ticks;
}

PartsAccount::Place PartsAccount::place_of(const TickRecord& record) {
  if (record.line != line_) {
    line_ = record.line;
    heading_ = static_cast<std::size_t>(
        std::ranges::upper_bound(headings_, line_, {}, &Heading::line) - headings_.begin());
  }
  return {.tool = record.tool, .heading = heading_};
}

void PartsAccount::end_rest() {
  const bool changes = last_.tool != tool_before_;
  for (const Rest& rest : rests_) {
    count(rest.place, changes ? &TimeSplit::tool_change : &TimeSplit::rest, rest.ticks);
  }
  rests_.clear();
}

void PartsAccount::add(const TickRecord& record) {
  if (has_last_) {
    const Place place = place_of(last_);
    const std::int64_t ticks = record.tick - last_.tick;
    if (kind_of(last_) != TickKind::rest) {
      count(place, kind_in_motion(last_), ticks);
    } else if (!rests_.empty() && rests_.back().place == place) {
      rests_.back().ticks += ticks;
    } else {
      rests_.push_back({.place = place, .ticks = ticks});
    }
  }
  const bool goes_on =
      kind_of(record) == TickKind::rest && !rests_.empty() && record.line == last_.line;
  if (!goes_on) {
    end_rest();
    tool_before_ = tool_change_ == ToolChange::takes_none ? record.tool : last_.tool;
  }
  last_ = record;
  has_last_ = true;
}

TimeParts PartsAccount::parts() const {
  PartsAccount ended = *this;
  ended.of_counted_ = nullptr;  // it counts for itself
  ended.end_rest();
  std::map<std::int32_t, TimeSplit> tools;
  std::map<std::size_t, TimeSplit> operations;
  for (const auto& [place, time] : ended.places_) {
    add_up(tools[place.tool], time);
    add_up(operations[place.heading], time);
  }
  TimeParts parts;
  for (const auto& [tool, time] : tools) {
    const std::string name = tool == 0 ? "no tool" : "T" + std::to_string(tool);
    append(parts.tools, {.name = name, .time = time});
  }
  for (const auto& [heading, time] : operations) {
    if (heading > 0) {
      const Heading& of = headings_[heading - 1];
      append(parts.operations, {.name = of.text, .line = of.line, .time = time});
    } else if (!headings_.empty()) {
      append(parts.operations, {.name = "before the first heading", .time = time});
    }
  }
  return parts;
}

}  // namespace kerf::program
