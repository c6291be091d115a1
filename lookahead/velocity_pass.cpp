#include "lookahead/velocity_pass.hpp"

#include <algorithm>

namespace kerf::lookahead {

namespace {

double keep_surest(WindowSpan& item, double v_begin_mm_s, const profiles::Profile& profile) {
  if (v_begin_mm_s >= item.sure.v_begin_mm_s) {
    item.sure = {.v_begin_mm_s = v_begin_mm_s,
                 .v_end_mm_s = std::min(item.v_end_mm_s, v_begin_mm_s)};
    if (!joins(item.span, item.sure, profile)) {
      item.sure.v_end_mm_s = 0.0;  // it was reached from there
    }
  }
  return item.sure.v_begin_mm_s;
}

}  // namespace

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
      if (!item.span.turning.empty()) {
        v_begin_of_next = keep_surest(item, v_begin_of_next, profile);
      }
      for_window = for_window && v_begin_of_next < cap;
    }
  }
}

}  // namespace kerf::lookahead
