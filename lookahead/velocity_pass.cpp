#include "lookahead/velocity_pass.hpp"

namespace kerf::lookahead {

void backward_pass(Window<WindowSpan>& window, const profiles::Profile& profile) {
  double v_begin_of_next = 0.0;
  bool for_window = true;
  for (std::size_t i = window.size(); i-- > 0;) {
    WindowSpan& item = window[i];
    item.v_end_before_mm_s = item.v_end_mm_s;
    item.v_end_mm_s = v_begin_of_next;
    item.brakes_for_window = for_window;
    if (i > 0) {
      const double cap = window[i - 1].span.end.feedrate_mm_s;
      v_begin_of_next =
          reach_backward_mm_s(item.span, {.v_end_mm_s = item.v_end_mm_s, .cap_mm_s = cap}, profile);
      for_window = for_window && v_begin_of_next < cap;
    }
  }
}

}  // namespace kerf::lookahead
