#include "bench/part_table.hpp"

#include <array>
#include <cstdio>

namespace kerf::bench {

namespace {

constexpr double kTolerance = 1.005;
constexpr double kNanometre_mm = 1e-6;

}  // namespace

void Table::print_head() {
  std::printf(
      "| program | F, a, J | mode | time [s] | at most [s] | others [s] | largest over its limit "
      "| ticks off the path [um] | path off the ticks [um] | ticks off their line [um] | wall "
      "[s] | lines/s | degradations | |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | "
      "--- | --- | --- | --- | --- |\n");
}

std::optional<PartRun> Table::add(const Row& row) {
  if (!wants(row.name) || (row.is_long && order_.quick)) {
    return std::nullopt;
  }
  const PartRun run = run_part(*row.program, row.mode, row.feed_mm_min, row.axes, order_.profile);
  const double allowed = row.mode.allowed_mm;
  const Deviation& off = run.deviation;
  const bool met = (row.at_most_s == 0.0 || run.time_s <= row.at_most_s) &&
                   run.over.ratio <= kTolerance && off.of_ticks_mm <= allowed + kNanometre_mm &&
                   off.of_path_mm <= allowed + kChord_mm &&
                   off.of_line_mm <= 2.0 * allowed + kNanometre_mm;
  std::array<char, 32> target{};
  if (row.at_most_s > 0.0) {
    std::snprintf(target.data(), target.size(), "%.3f", row.at_most_s);
  }
  std::printf(
      "| %s | %.0f, %.0f, %.0f | %s | %.3f | %s | %s | %.4f (%s) | %.3f | %.3f | %.3f | %.2f | "
      "%.0f | %llu | %s |\n",
      row.name.c_str(), row.feed_mm_min, row.axes.acceleration_mm_s2, row.axes.jerk_mm_s3,
      row.mode.codes.c_str(), run.time_s, target.data(), row.others.c_str(), run.over.ratio,
      run.over.what.c_str(), 1e3 * off.of_ticks_mm, 1e3 * off.of_path_mm, 1e3 * off.of_line_mm,
      run.wall_s, static_cast<double>(run.lines) / run.wall_s,
      static_cast<unsigned long long>(run.degradations), met ? "met" : "MISSED");
  std::fflush(stdout);
  met_ = met_ && met;
  return run;
}

void Table::note(const std::string& what, bool met) {
  notes_ += "- " + what + (met ? ": met\n" : ": MISSED\n");
  met_ = met_ && met;
}

bool Table::finish() const {
  std::printf("\n%s", notes_.c_str());
  return met_;
}

}  // namespace kerf::bench
