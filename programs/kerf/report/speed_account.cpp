#include "programs/kerf/report/speed_account.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace kerf::program {

namespace {

constexpr std::size_t kShownLines = 5;

using Counts = std::array<std::int64_t, interp::kConstraints>;

LineSpeed line_speed(std::uint32_t line, const Counts& counts) {
  LineSpeed speed;
  speed.line = line;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) {
      speed.limits.push_back({.limit = static_cast<Constraint>(i), .ticks = counts[i]});
      speed.ticks += counts[i];
    }
  }
  std::stable_sort(speed.limits.begin(), speed.limits.end(),
                   [](const LimitTime& a, const LimitTime& b) { return a.ticks > b.ticks; });
  return speed;
}

// Keeps those that take the longest.
void keep_longest(std::vector<LineSpeed>& lines, LineSpeed line) {
  const auto after =
      std::upper_bound(lines.begin(), lines.end(), line,
                       [](const LineSpeed& a, const LineSpeed& b) { return a.ticks > b.ticks; });
  lines.insert(after, std::move(line));
  lines.resize(std::min(lines.size(), kShownLines));
}

}  // namespace

SpeedAccount::SpeedAccount(const SpeedQuestion& question, double period_s) : question_(question) {
  if (question.time_s) {
    asked_tick_ = std::llround(*question.time_s / period_s);
  }
}

std::vector<LineLimitTime> SpeedAccount::merged(std::vector<LineLimitTime> entries) {
  std::sort(entries.begin(), entries.end(), [](const LineLimitTime& a, const LineLimitTime& b) {
    return std::tie(a.line, a.limit) < std::tie(b.line, b.limit);
  });
  std::vector<LineLimitTime> result;
  for (const LineLimitTime& entry : entries) {
    if (!result.empty() && result.back().line == entry.line && result.back().limit == entry.limit) {
      result.back().ticks += entry.ticks;
    } else {
      result.push_back(entry);
    }
  }
  return result;
}

void SpeedAccount::add(const TickRecord& record) {
  if (record.tick == asked_tick_) {
    tick_ = TickSpeed{.tick = record.tick,
                      .line = record.line,
                      .v_mm_s = record.motion.v_mm_s,
                      .limit = record.limit};
  }
  if (last_) {
    stops_ += !last_->detail.at_rest && record.detail.at_rest ? 1 : 0;
    const std::int64_t periods = record.tick - last_->tick;
    if (!entries_.empty() && entries_.back().line == last_->line &&
        entries_.back().limit == last_->limit) {
      entries_.back().ticks += periods;
    } else {
      entries_.push_back({.line = last_->line, .limit = last_->limit, .ticks = periods});
    }
  }
  last_ = record;
  if (entries_.size() >= merge_at_) {
    entries_ = merged(std::move(entries_));
    merge_at_ = std::max(merge_at_, 2 * entries_.size());
  }
}

SpeedReport SpeedAccount::report() const {
  std::vector<LineLimitTime> entries = merged(entries_);
  SpeedReport report;
  report.stops = stops_;
  report.tick = tick_;
  Counts whole{};
  for (std::size_t i = 0; i < entries.size();) {
    Counts counts{};
    const std::uint32_t line = entries[i].line;
    for (; i < entries.size() && entries[i].line == line; ++i) {
      const auto limit = static_cast<std::size_t>(entries[i].limit);
      counts[limit] += entries[i].ticks;
      whole[limit] += entries[i].ticks;
    }
    if (!question_.line || *question_.line == line) {
      keep_longest(report.lines, line_speed(line, counts));
    }
  }
  report.whole = line_speed(0, whole);
  if (question_.each_line) {
    report.each_line = std::move(entries);
  }
  return report;
}

}  // namespace kerf::program
