#include "lookahead/classical/velocity_pass.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace kerf::lookahead {

namespace {

void keep_surest(WindowSegment& item, double v_begin_mm_s, const profiles::Profile& profile) {
  if (v_begin_mm_s < item.sure.v_begin_mm_s) {
    return;
  }
  item.sure = {.v_begin_mm_s = v_begin_mm_s, .v_end_mm_s = std::min(item.v_end_mm_s, v_begin_mm_s)};
  const bool may_need_rest =
      !item.segment.axis_limits.empty() || item.segment.end.constant_velocity_s > 0.0;
  if (may_need_rest && !joins(item.segment, item.sure, profile)) {
    item.sure.v_end_mm_s = 0.0;  // it was reached from there
  }
}

}  // namespace

void backward_pass(Window<WindowSegment>& window, const profiles::Profile& profile) {
  double v_begin_of_next = 0.0;
  bool for_window = true;
  for (std::size_t i = window.size(); i-- > 0;) {
    WindowSegment& item = window[i];
    item.v_end_mm_s = v_begin_of_next;
    item.brakes_for_window = for_window;
    if (i > 0) {
      const double cap = window[i - 1].segment.end.feedrate_mm_s;
      const SegmentEnds ends =
          ends_backward(item.segment, {.v_end_mm_s = item.v_end_mm_s, .cap_mm_s = cap}, profile);
      item.v_end_mm_s = ends.v_end_mm_s;
      v_begin_of_next = ends.v_begin_mm_s;
      keep_surest(item, v_begin_of_next, profile);
      if (!item.segment.axis_limits.empty()) {
        v_begin_of_next = item.sure.v_begin_mm_s;
      }
      for_window = for_window && v_begin_of_next < cap;
    }
  }
}

bool begin_in_motion(WindowSegment& first, double v_mm_s, const profiles::Profile& profile) {
  const Slope& rise = first.segment.rise;
  if (v_mm_s > first.segment.limits.feedrate_mm_s ||
      (!rise.empty() && v_mm_s > rise.bottom_mm_s()) ||
      reach_backward_mm_s(first.segment, {.v_end_mm_s = first.v_end_mm_s, .cap_mm_s = v_mm_s},
                          profile) < v_mm_s) {
    return false;
  }
  keep_surest(first, v_mm_s, profile);
  return true;
}

Ending ending_of(const WindowSegment& item, const SegmentEnds& wanted,
                 const profiles::Profile& profile) {
  assert(wanted.v_begin_mm_s <= item.sure.v_begin_mm_s);
  SegmentEnds ends = wanted;
  ends.v_end_mm_s = end_feedrate_mm_s(item.segment, wanted, item.sure.v_end_mm_s, profile);
  const bool rises = ends.v_end_mm_s > ends.v_begin_mm_s;
  if ((rises && item.segment.axis_limits.empty()) || joins(item.segment, ends, profile)) {
    return {.v_end_mm_s = ends.v_end_mm_s};
  }
  const double factor = ends.v_begin_mm_s / item.sure.v_begin_mm_s;
  return {.v_end_mm_s = item.sure.v_end_mm_s * factor, .is_slowed = true};
}

SegmentPlan plan_joined(const WindowSegment& item, const Ending& ending, double v_begin_mm_s,
                        const profiles::Profile& profile) {
  return ending.is_slowed ? slowed_plan(item.segment, item.sure, v_begin_mm_s, profile)
                          : plan_segment(item.segment, {v_begin_mm_s, ending.v_end_mm_s}, profile);
}

std::vector<double> BlockRuns::rest_to_rest_s(const std::vector<VelocitySegment>& segments) {
  Window<WindowSegment> window;
  for (const VelocitySegment& segment : segments) {
    window.push_back({.segment = segment});
  }
  return durations_s(std::move(window));
}

std::vector<double> BlockRuns::in_motion_s(const std::vector<VelocitySegment>& segments,
                                           bool begins_at_rest) {
  const auto line_beside = [&](const VelocitySegment& segment, double v_mm_s) {
    VelocitySegment line{.limits = segment.limits};
    line.limits.feedrate_mm_s = std::min(segment.limits.feedrate_mm_s, v_mm_s);
    line.length_mm =
        profile_.length_mm({.v_end_mm_s = line.limits.feedrate_mm_s}, line.limits.ramp);
    line.end.feedrate_mm_s = line.limits.feedrate_mm_s;
    return line;
  };
  Window<WindowSegment> window;
  if (!begins_at_rest) {
    const VelocitySegment& first = segments.front();
    VelocitySegment before = line_beside(first, first.rise.bottom_mm_s());
    before.s_begin_mm = -before.length_mm;
    window.push_back({.segment = before});
  }
  for (const VelocitySegment& segment : segments) {
    window.push_back({.segment = segment});
  }
  const VelocitySegment& last = segments.back();
  VelocitySegment behind = line_beside(last, last.fall.bottom_mm_s());
  behind.s_begin_mm = last.s_begin_mm + last.length_mm;
  window.back().segment.end.feedrate_mm_s = behind.limits.feedrate_mm_s;
  window.push_back({.segment = behind});

  std::vector<double> all_s = durations_s(std::move(window));
  const double behind_s = all_s.back();
  all_s.pop_back();
  all_s.back() += behind_s;
  if (!begins_at_rest) {
    all_s[1] += all_s.front();
    all_s.erase(all_s.begin());
  }
  return all_s;
}

std::vector<double> BlockRuns::durations_s(Window<WindowSegment> window) {
  backward_pass(window, profile_);
  std::vector<double> durations_s;
  double v_mm_s = 0.0;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const VelocitySegment& segment = window[i].segment;
    SegmentEnds ends{.v_begin_mm_s = v_mm_s, .v_end_mm_s = window[i].v_end_mm_s};
    const Ending ending = ending_of(window[i], ends, profile_);
    ends.v_end_mm_s = v_mm_s = ending.v_end_mm_s;
    const auto [known, is_new] = known_s_.try_emplace(
        {segment.s_begin_mm, segment.length_mm, ends.v_begin_mm_s, ends.v_end_mm_s});
    if (is_new) {
      known->second = plan_joined(window[i], ending, ends.v_begin_mm_s, profile_).duration_s();
    }
    durations_s.push_back(known->second);
  }
  return durations_s;
}

}  // namespace kerf::lookahead
