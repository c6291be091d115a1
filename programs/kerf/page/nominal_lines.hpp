// About how long the lines of a program take, before their times are planned.
#pragma once

#include <cstdint>
#include <vector>

#include <kerf/machine.hpp>

#include "lookahead/event_time.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::program {

// Length divided by feedrate, or what the axes take for the way from begin to end if that is
// longer; dwells and what the machine file says of events. Weakness: a line that begins or ends
// slower takes longer. The shares of lines among which that is alike are right.
class NominalLines {
 public:
  struct Settings {
    MachineLimits limits{};
    lookahead::EventTime::Settings events{};
    double feed_override = 1.0;  // > 0
  };
  explicit NominalLines(const Settings& settings)
      : limits_(settings.limits),
        events_(settings.events),
        feed_override_(settings.feed_override) {}

  // As they are run.
  void add(const smoothing::PathSegment& segment);
  void add(const parser::Move& move);

  struct Line {
    double duration_s = 0.0;  // in all its rounds; 0: it takes no time
    double end_mm = 0.0;      // of the last one, along the path as a setpoint counts it
  };
  // By line of the program.
  [[nodiscard]] const std::vector<Line>& lines() const noexcept { return lines_; }

 private:
  [[nodiscard]] double nominal_s(const smoothing::PathSegment& segment) const;
  void count(std::uint32_t line, double duration_s);

  MachineLimits limits_;
  lookahead::EventTime events_;
  double feed_override_;
  double path_mm_ = 0.0;
  std::vector<Line> lines_;
};

}  // namespace kerf::program
