#include "lookahead/velocity_pass.hpp"

namespace kerf::lookahead {

void backward_pass(std::deque<WindowSpan>& window, const profiles::Profile& profile) {
  double v_begin_of_next = 0.0;
  for (auto item = window.rbegin(); item != window.rend(); ++item) {
    item->v_end_mm_s = v_begin_of_next;
    const auto before = std::next(item);
    if (before != window.rend()) {
      v_begin_of_next = reach_backward_mm_s(
          item->span, {.v_end_mm_s = item->v_end_mm_s, .cap_mm_s = before->span.end.feedrate_mm_s},
          profile);
    }
  }
}

}  // namespace kerf::lookahead
