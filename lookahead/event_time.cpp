#include "lookahead/event_time.hpp"

#include <utility>

namespace kerf::lookahead {

double EventTime::next_s(const parser::EventMove& event) noexcept {
  using parser::EventKind;
  switch (event.kind) {
    case EventKind::spindle_cw:
    case EventKind::spindle_ccw:
      return std::exchange(turns_, event.value != 0.0) || !turns_ || event.taps ? 0.0
                                                                                : spindle_start_s_;
    case EventKind::spindle_off:
    case EventKind::spindle_orient:
    case EventKind::program_end:
      turns_ = false;
      return 0.0;
    case EventKind::tool_change:
      turns_ = false;
      return tool_change_s_;
    default:
      return 0.0;
  }
}

}  // namespace kerf::lookahead
