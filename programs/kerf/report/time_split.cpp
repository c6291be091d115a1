#include "programs/kerf/report/time_split.hpp"

namespace kerf::program {

void TimeAccount::end_rest(TimeSplit& split) const noexcept {
  (last_.tool != tool_before_ ? split.tool_change : split.rest) += rest_;
}

void TimeAccount::add(const TickRecord& record) noexcept {
  if (has_last_) {
    const std::int64_t ticks = record.tick - last_.tick;
    switch (kind_of(last_)) {
      case TickKind::cut:
        split_.approach = has_cut_ ? split_.approach : split_.rapid;
        has_cut_ = true;
        split_.cutting += ticks;
        break;
      case TickKind::rapid:
        split_.rapid += ticks;
        break;
      case TickKind::rest:
        rest_ += ticks;
        break;
    }
  }
  const bool goes_on = kind_of(record) == TickKind::rest && rest_ > 0 && record.line == last_.line;
  if (!goes_on) {
    end_rest(split_);
    rest_ = 0;
    tool_before_ = tool_change_ == ToolChange::takes_none ? record.tool : last_.tool;
  }
  last_ = record;
  has_last_ = true;
}

TimeSplit TimeAccount::split() const noexcept {
  TimeSplit split = split_;
  end_rest(split);
  return split;
}

}  // namespace kerf::program
