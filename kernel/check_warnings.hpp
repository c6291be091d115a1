// Warnings of the check: a feed that the machine cannot reach, and a G64 tolerance larger than the
// moves it applies to.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include <kerf/machine.hpp>

#include "diagnostics/diagnostic.hpp"
#include "lookahead/path/limits.hpp"
#include "parser/moves/move.hpp"

namespace kerf {

class CheckWarnings {
 public:
  explicit CheckWarnings(const lookahead::PlanLimits& limits);

  // The next move of the program.
  void look_at(const parser::Move& move, std::vector<diagnostics::Diagnostic>& found);
  // No move follows.
  void finish(std::vector<diagnostics::Diagnostic>& found) { end_run(found); }

 private:
  struct Box {
    parser::Point min_mm{};
    parser::Point max_mm{};
    void include(const parser::Point& point_mm);
    [[nodiscard]] double size_mm() const;  // its longest side
  };
  struct Vertex {
    parser::Point place_mm{};
    diagnostics::SourcePosition source;  // of the line that begins here
  };

  void check_feed(const parser::Move& move, std::vector<diagnostics::Diagnostic>& found);
  void take_line(const parser::Move& move, std::vector<diagnostics::Diagnostic>& found);
  [[nodiscard]] const Vertex* loop_to(const parser::Point& end_mm, double tolerance_mm) const;
  void end_run(std::vector<diagnostics::Diagnostic>& found);
  // One warning per tolerance, and only for the first few.
  [[nodiscard]] bool is_told(double tolerance_mm) const;

  lookahead::PlanLimits limits_;
  double reach_mm_s_;  // highest feedrate in any direction
  bool feed_told_ = false;
  // Straight feeds under one G64, with nothing between them.
  std::deque<Vertex> vertices_;  // the most recent ones
  Box box_;
  diagnostics::SourcePosition run_begin_;
  std::uint64_t lines_ = 0;
  double tolerance_mm_ = 0.0;
  double merge_mm_ = 0.0;
  std::vector<double> told_mm_;  // tolerances with a warning
};

}  // namespace kerf
