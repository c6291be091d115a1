#include "lookahead/event_time.hpp"

#include <utility>

namespace kerf::lookahead {

double EventTime::next_s(const parser::EventMove& event) noexcept {
  using parser::EventKind;
  bool& turns = settings_.spindle_turns;
  switch (event.kind) {
    case EventKind::spindle_cw:
    case EventKind::spindle_ccw:
      return std::exchange(turns, event.value != 0.0) || !turns || event.taps
                 ? 0.0
                 : settings_.spindle_start_s;
    case EventKind::spindle_off:
    case EventKind::spindle_orient:
    case EventKind::program_end:
      turns = false;
      return 0.0;
    case EventKind::tool_change:
      turns = false;
      return settings_.tool_change_s;
    default:
      return 0.0;
  }
}

}  // namespace kerf::lookahead
