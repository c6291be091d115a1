// Where the times of two programs differ, or of one on two machines.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "programs/kerf/compare/line_match.hpp"
#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// Of the first and of the second, in s.
using TwoTimes = std::array<double, 2>;

// How much longer the second takes.
inline double difference_s(const TwoTimes& times_s) noexcept {
  return times_s[1] - times_s[0];
}

struct LimitShare {
  Constraint limit{};
  double time_s = 0.0;
};

// The same limit in both.
struct LimitDifference {
  Constraint limit{};
  TwoTimes times_s{};
};

// Lines of one of the two.
struct ComparedLines {
  LineSpan span{};
  std::string text{};                // of the first of them
  std::vector<LimitShare> limits{};  // the longest first
};

struct LineDifference {
  std::array<ComparedLines, 2> lines{};
  TwoTimes times_s{};
};

struct Comparison {
  TwoTimes cycle_s{};
  TwoTimes cutting_s{};
  TwoTimes rapid_s{};
  TwoTimes rest_s{};
  TwoTimes tool_change_s{};
  std::vector<LimitDifference> limits;  // those that differ most first
  std::vector<LineDifference> lines;    // the same, as many as are asked for
  std::size_t other_lines = 0;          // that differ, too
  double other_lines_s = 0.0;           // by how much, all together
};

// A program that has run for a comparison: plan, motion and speed are there, with each line.
struct ComparedProgram {
  const FileReport& report;
  const std::string& source;
};

// max_lines: how many lines it names.
[[nodiscard]] Comparison compare_programs(const ComparedProgram& first,
                                          const ComparedProgram& second, std::size_t max_lines);

}  // namespace kerf::program
