#include "programs/kerf/control/status_line.hpp"

#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "programs/kerf/io/number_text.hpp"

namespace kerf::program {

namespace {

std::string awaited_answer(const ControllerStatus& status) {
  switch (status.wait_cause) {
    case WaitCause::program_stop:
      return "for an operator (program stop, M0)";
    case WaitCause::optional_stop:
      return "for an operator (optional stop, M1)";
    case WaitCause::pallet_change:
      return "for the pallet change (M60)";
    case WaitCause::tool_change:
      return fmt::format("for tool {} (M6)", status.setpoint.outputs.tool);
    case WaitCause::block_end:
      return "after a block (single block)";
    case WaitCause::start:
      return "for an operator (start here)";
    case WaitCause::none:
      break;
  }
  return "for an operator";
}

bool stops_feed(const ControllerStatus& status) noexcept {
  return status.feed_inputs.stop && status.setpoint.outputs.heeds_feed_stop;
}

// Empty: it moves, or the state says it.
std::string why_it_stands(const ControllerStatus& status) {
  switch (status.waits_for) {
    case WaitsFor::answer:
      return awaited_answer(status) + (status.door_open ? ": the door is open" : ": Enter goes on");
    case WaitsFor::text:
      return "for text";
    case WaitsFor::planning:
      return "for planning";
    case WaitsFor::machine:
      return "for the machine";
    case WaitsFor::nothing:
      break;
  }
  if (status.door_open) {
    return "the door is open";
  }
  if (!status.is_held_by_feed || status.state != ControllerState::running) {
    return "";
  }
  return !is_held_by_machine(status) ? "stands: the feed is at 0 %"
         : stops_feed(status)        ? "stands: the machine stops the feed"
                                     : "stands: the machine's feed is at 0 %";
}

}  // namespace

std::string status_line(const ControllerStatus& status) {
  constexpr double kPerMinute = 60.0;
  const std::string why = why_it_stands(status);
  return fmt::format(
      "{:9} line {:<6} {} {:3} %{}{}", name_of(status.state), status.setpoint.line,
      why.empty() ? fmt::format("F{:<6.0f}", kPerMinute * status.setpoint.v_mm_s) : why,
      std::lround(100.0 * status.overrides.feed), status.single_block ? " single block" : "",
      status.left_s ? " left " + clock_time(*status.left_s) : "");
}

bool is_held_by_machine(const ControllerStatus& status) noexcept {
  return stops_feed(status) || (status.setpoint.outputs.follows_adaptive_feed &&
                                status.feed_inputs.adaptive < Overrides::kLeastFeed);
}

std::string call_for_answer(const ControllerStatus& status) {
  return fmt::format("waiting at line {} {}: Enter goes on", status.setpoint.line,
                     awaited_answer(status));
}

}  // namespace kerf::program
