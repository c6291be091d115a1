#include "programs/kerf/compare/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <utility>

namespace kerf::program {

namespace {

bool takes_longer(const LimitShare& a, const LimitShare& b) {
  return a.time_s > b.time_s;
}

template <typename Difference>
bool differs_more(const Difference& a, const Difference& b) {
  return std::abs(difference_s(a.times_s)) > std::abs(difference_s(b.times_s));
}

// One of the two, line by line.
class Side {
 public:
  explicit Side(const ComparedProgram& program)
      : period_s_(program.report.period_s),
        times_(program.report.speed->each_line),
        lines_(lines_of(program.source)),
        text_lines_(lines_.size()) {
    // A line whose text is not there has its number alone.
    const std::size_t last = times_.empty() ? 0 : times_.back().line;
    for (std::size_t number = text_lines_ + 1; number <= last; ++number) {
      lines_.push_back("line " + std::to_string(number));
    }
  }

  [[nodiscard]] const std::vector<std::string>& lines() const noexcept { return lines_; }

  [[nodiscard]] std::int64_t ticks(const LineSpan& span) const {
    std::int64_t ticks = 0;
    for (const LineLimitTime& time : in(span)) {
      ticks += time.ticks;
    }
    return ticks;
  }
  [[nodiscard]] double seconds(std::int64_t ticks) const {
    return static_cast<double>(ticks) * period_s_;
  }

  [[nodiscard]] ComparedLines describe(const LineSpan& span) const {
    ComparedLines lines{.span = span};
    if (!span.is_empty() && span.first <= text_lines_) {
      lines.text = lines_[span.first - 1];
    }
    std::map<Constraint, std::int64_t> limits;
    for (const LineLimitTime& time : in(span)) {
      limits[time.limit] += time.ticks;
    }
    for (const auto& [limit, ticks] : limits) {
      lines.limits.push_back({.limit = limit, .time_s = seconds(ticks)});
    }
    std::stable_sort(lines.limits.begin(), lines.limits.end(), takes_longer);
    return lines;
  }

 private:
  [[nodiscard]] std::span<const LineLimitTime> in(const LineSpan& span) const {
    const auto first_from = [this](std::uint32_t line) {
      return std::partition_point(times_.begin(), times_.end(),
                                  [line](const LineLimitTime& time) { return time.line < line; });
    };
    return span.is_empty() ? std::span<const LineLimitTime>{}
                           : std::span(first_from(span.first), first_from(span.last + 1));
  }

  double period_s_;
  const std::vector<LineLimitTime>& times_;  // by line
  std::vector<std::string> lines_;
  std::size_t text_lines_;
};

void compare_limits(const std::array<const FileReport*, 2>& reports, Comparison& comparison) {
  std::map<Constraint, TwoTimes> limits;
  for (std::size_t k = 0; k < reports.size(); ++k) {
    for (const LimitTime& part : reports[k]->speed->whole.limits) {
      limits[part.limit][k] = static_cast<double>(part.ticks) * reports[k]->period_s;
    }
  }
  for (const auto& [limit, times_s] : limits) {
    comparison.limits.push_back({.limit = limit, .times_s = times_s});
  }
  std::stable_sort(comparison.limits.begin(), comparison.limits.end(),
                   differs_more<LimitDifference>);
}

// What is sorted before the lines that are shown are described.
struct TimedPair {
  const MatchedLines* lines = nullptr;
  TwoTimes times_s{};
};

void compare_lines(const std::array<Side, 2>& sides, std::size_t max_lines,
                   Comparison& comparison) {
  const std::vector<MatchedLines> matched = match_lines(sides[0].lines(), sides[1].lines());
  std::vector<TimedPair> differing;
  for (const MatchedLines& lines : matched) {
    const TwoTimes times_s{sides[0].seconds(sides[0].ticks(lines.first)),
                           sides[1].seconds(sides[1].ticks(lines.second))};
    if (times_s[0] != times_s[1]) {
      differing.push_back({.lines = &lines, .times_s = times_s});
    }
  }
  std::stable_sort(differing.begin(), differing.end(), differs_more<TimedPair>);
  for (std::size_t i = 0; i < differing.size(); ++i) {
    const TimedPair& pair = differing[i];
    if (i < max_lines) {
      comparison.lines.push_back(
          {.lines = {sides[0].describe(pair.lines->first), sides[1].describe(pair.lines->second)},
           .times_s = pair.times_s});
    } else {
      ++comparison.other_lines;
      comparison.other_lines_s += difference_s(pair.times_s);
    }
  }
}

}  // namespace

Comparison compare_programs(const ComparedProgram& first, const ComparedProgram& second,
                            std::size_t max_lines) {
  const std::array reports{&first.report, &second.report};
  Comparison comparison;
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const TimeSplit& time = reports[k]->motion->time;
    const auto seconds = [&](std::int64_t ticks) {
      return static_cast<double>(ticks) * reports[k]->period_s;
    };
    comparison.cycle_s[k] = reports[k]->plan->cycle_time_s;
    comparison.cutting_s[k] = seconds(time.cutting);
    comparison.rapid_s[k] = seconds(time.rapid);
    comparison.rest_s[k] = seconds(time.rest);
    comparison.tool_change_s[k] = seconds(time.tool_change);
  }
  compare_limits(reports, comparison);
  compare_lines({Side(first), Side(second)}, max_lines, comparison);
  return comparison;
}

}  // namespace kerf::program
