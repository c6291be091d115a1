#include <optional>
#include <utility>

#include "interp/outputs.hpp"
#include "lookahead/planner.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kRadPerRevolution = 6.283185307179586477;

double rad_s_from(double per_min) {
  return per_min * kRadPerRevolution / 60.0;
}

interp::OutputChange spindle_of(const parser::EventMove& event) {
  const double sign = event.kind == parser::EventKind::spindle_cw ? 1.0 : -1.0;
  const parser::SurfaceFollowing& surface = event.surface;
  interp::OutputChange change{.kind = interp::OutputChangeKind::spindle,
                              .value = sign * rad_s_from(event.value)};
  if (surface.mm_s != 0.0) {
    change.surface = {.mm_s = sign * surface.mm_s,
                      .max_rad_s = rad_s_from(surface.max_per_min),
                      .per_x = surface.per_x,
                      .per_y = surface.per_y,
                      .at_origin_mm = surface.at_origin_mm};
  }
  return change;
}

// Nothing: the event changes no output (a stop).
std::optional<interp::OutputChange> output_change_of(const parser::EventMove& event) {
  using interp::OutputChange;
  using interp::OutputChangeKind;
  using parser::EventKind;
  switch (event.kind) {
    case EventKind::program_end:
      return OutputChange{.kind = OutputChangeKind::all_off};
    case EventKind::spindle_cw:
    case EventKind::spindle_ccw:
      return spindle_of(event);
    case EventKind::spindle_off:
      return OutputChange{.kind = OutputChangeKind::spindle};
    case EventKind::spindle_orient:
      return OutputChange{.kind = OutputChangeKind::hold_spindle, .value = event.value};
    case EventKind::tool_change:
      return OutputChange{.kind = OutputChangeKind::tool_change, .value = event.value};
    case EventKind::tool_number:
      return OutputChange{.kind = OutputChangeKind::tool_number, .value = event.value};
    case EventKind::mist_on:
      return OutputChange{.kind = OutputChangeKind::mist_on};
    case EventKind::flood_on:
      return OutputChange{.kind = OutputChangeKind::flood_on};
    case EventKind::coolant_off:
      return OutputChange{.kind = OutputChangeKind::coolant_off};
    case EventKind::speed_override:
      return OutputChange{.kind = OutputChangeKind::speed_override, .value = event.value};
    case EventKind::adaptive_feed:
      return OutputChange{.kind = OutputChangeKind::adaptive_feed, .value = event.value};
    case EventKind::feed_stop:
      return OutputChange{.kind = OutputChangeKind::feed_stop, .value = event.value};
    case EventKind::digital_output:
    case EventKind::digital_at_motion:
      return OutputChange{
          .kind = OutputChangeKind::digital, .index = event.index, .value = event.value};
    case EventKind::analog_output:
    case EventKind::analog_at_motion:
      return OutputChange{
          .kind = OutputChangeKind::analog, .index = event.index, .value = event.value};
    default:
      return std::nullopt;
  }
}

// Nothing: neither somebody nor the machine is waited for.
std::optional<PlanWait::Kind> wait_kind(parser::EventKind kind) {
  using parser::EventKind;
  switch (kind) {
    case EventKind::program_stop:
      return PlanWait::Kind::program_stop;
    case EventKind::optional_stop:
      return PlanWait::Kind::optional_stop;
    case EventKind::pallet_change:
      return PlanWait::Kind::pallet_change;
    case EventKind::tool_change:
      return PlanWait::Kind::tool_change;
    case EventKind::spindle_cw:
    case EventKind::spindle_ccw:
      return PlanWait::Kind::spindle_start;
    default:
      return std::nullopt;
  }
}

// M1 counts where it would stop, a spindle where its start takes time.
RestTime note_wait(const parser::EventMove& event, std::uint32_t line, Planner& planner) {
  const RestTime time = planner.rest_time(event);
  const auto kind = wait_kind(event.kind);
  const bool counts = kind == PlanWait::Kind::optional_stop   ? planner.stops_optionally()
                      : kind == PlanWait::Kind::spindle_start ? time.planned_s > 0.0
                                                              : kind.has_value();
  if (counts) {
    const bool changes_tool = kind == PlanWait::Kind::tool_change;
    planner.note_wait({.line = line,
                       .kind = *kind,
                       .tool = changes_tool ? static_cast<std::int32_t>(event.value) : 0,
                       .duration_s = time.planned_s});
  }
  return time;
}

WaitCause cause_of(parser::EventKind kind) {
  switch (kind) {
    case parser::EventKind::program_stop:
      return WaitCause::program_stop;
    case parser::EventKind::optional_stop:
      return WaitCause::optional_stop;
    case parser::EventKind::pallet_change:
      return WaitCause::pallet_change;
    case parser::EventKind::tool_change:
      return WaitCause::tool_change;
    case parser::EventKind::start:
      return WaitCause::start;
    default:
      return WaitCause::none;
  }
}

RestTime push_event(const parser::EventMove& event, const Planner::RestPlace& at,
                    Planner& planner) {
  const auto change = output_change_of(event);
  const RestTime time = note_wait(event, at.line, planner);
  if (event.kind == parser::EventKind::ask_machine) {
    planner.push_machine_wait(at);
  } else if (planner.waits_at(event.kind)) {
    planner.push_wait(change, cause_of(event.kind), at);
  } else if (!change) {
    planner.push_rest(0.0, at);
  } else if (parser::is_of_override(event.kind)) {
    planner.push_change_at_next(*change);
  } else if (parser::is_at_motion(event.kind)) {
    planner.push_change_at_motion(*change);
  } else {
    planner.push_change_at_rest(*change, at, time.planned_s);
  }
  return time;
}

}  // namespace

RestTime push_pause(const parser::Move& pause, Planner& planner) {
  const Planner::RestPlace at{
      .line = pause.source.program_line(), .run_block = pause.block, .follows = pause.follows};
  if (const auto* dwell = std::get_if<parser::DwellMove>(&pause.shape)) {
    planner.push_rest(dwell->duration_s, at);
    return {.planned_s = dwell->duration_s, .expected_s = dwell->assumed ? 0.0 : dwell->duration_s};
  }
  const auto* event = std::get_if<parser::EventMove>(&pause.shape);
  return event != nullptr ? push_event(*event, at, planner) : RestTime{};
}

void push_block(Block block, const std::vector<parser::EventMove>& changes, Planner& planner) {
  for (const parser::EventMove& change : changes) {
    static_cast<void>(
        push_event(change, {.line = block.line, .run_block = block.run_block}, planner));
  }
  planner.push(std::move(block));
}

}  // namespace kerf::lookahead
