// How long the tool rests for what a program asks of the machine.
#pragma once

#include "parser/moves/move.hpp"

namespace kerf::lookahead {

// Of a dwell or an event.
struct RestTime {
  double planned_s = 0.0;   // 0 too where it waits for an answer
  double expected_s = 0.0;  // as NominalTime::rest_s counts it
};

// Of the events in program order: a spindle that turns already takes no time to start.
class EventTime {
 public:
  struct Settings {
    double tool_change_s = 0.0;
    double spindle_start_s = 0.0;
    bool spindle_turns = false;  // at the begin
  };
  explicit EventTime(const Settings& settings) noexcept
      : tool_change_s_(settings.tool_change_s),
        spindle_start_s_(settings.spindle_start_s),
        turns_(settings.spindle_turns) {}

  // Of the next one, where nobody is asked.
  [[nodiscard]] double next_s(const parser::EventMove& event) noexcept;

 private:
  double tool_change_s_;
  double spindle_start_s_;
  bool turns_;  // the spindle, after the latest event
};

}  // namespace kerf::lookahead
