#include "programs/kerf/control/request_execution.hpp"

#include <algorithm>

namespace kerf::program {

tl::expected<void, Refusal> RequestExecution::carry_out(const ControlRequest& request) {
  switch (request.kind) {
    case ControlRequest::Kind::override: {
      Overrides overrides = by_->status().overrides;
      overrides.feed = request.feed.value_or(overrides.feed);
      overrides.rapid = request.rapid.value_or(overrides.rapid);
      overrides.spindle = request.spindle.value_or(overrides.spindle);
      return by_->give(overrides);
    }
    case ControlRequest::Kind::single_block:
      return by_->give(SingleBlock{.is_on = request.on});
    case ControlRequest::Kind::optional_stop:
      return by_->give(OptionalStop{.is_on = request.on});
    case ControlRequest::Kind::block_delete:
      return by_->give(request.switches);
    case ControlRequest::Kind::mdi:
      return run_mdi(request.line);
    case ControlRequest::Kind::jog:
      return by_->give(request.jog);
    case ControlRequest::Kind::input:
      return set_input(request);
    case ControlRequest::Kind::fault:
      if (order_.break_down && order_.break_down(request.fault)) {
        return {};
      }
      return tl::unexpected(Refusal{.state = by_->status().state,
                                    .reason = "only the simulated table can be broken"});
    case ControlRequest::Kind::tool:
      return set_tool(request.tool);
    case ControlRequest::Kind::command:
    case ControlRequest::Kind::status:
    case ControlRequest::Kind::events:
      break;
  }
  return by_->give(request.command);
}

// With the first error of a line that has one.
tl::expected<void, Refusal> RequestExecution::run_mdi(const std::string& line) {
  auto given = by_->give(MdiLine{.text = line});
  if (!given && given.error().of_line) {
    const auto& found = by_->controller().program()->diagnostics();
    const auto error = std::ranges::find(found, Severity::error, &Diagnostic::severity);
    wrong_line_ = error->message + " [" + identifier(*error->page) + "]";
    given.error().reason = wrong_line_;
  }
  return given;
}

// What was not measured stays as the table has it.
tl::expected<void, Refusal> RequestExecution::set_tool(const MeasuredTool& measured) {
  const Tool* known = order_.tools.find(measured.number);
  Tool tool = known != nullptr ? *known : Tool{};
  tool.pocket = tool.number == measured.number ? tool.pocket : measured.number;
  tool.number = measured.number;
  tool.offset_mm[2] = measured.length_mm;
  tool.length_wear_mm = 0.0;
  if (measured.diameter_mm) {
    tool.diameter_mm = *measured.diameter_mm;
    tool.radius_wear_mm = 0.0;
  }
  auto given = by_->give(tool);  // also of a tool that is not in the table: it is refused
  if (given) {
    order_.tools.put(tool);
  }
  return given;
}

tl::expected<void, Refusal> RequestExecution::set_input(const ControlRequest& request) {
  const ControllerStatus status = by_->status();
  const auto refused = [&](std::string_view why) {
    return tl::unexpected(Refusal{.state = status.state, .reason = why});
  };
  if (order_.machine_has_inputs) {
    return refused("the machine says what its inputs are");
  }
  FeedInputs inputs = status.feed_inputs;
  if (request.analog && order_.feed_inputs.adaptive_feed == request.analog) {
    inputs.adaptive = request.value;
  } else if (request.digital && order_.feed_inputs.feed_stop == request.digital) {
    inputs.stop = request.value != 0.0;
  } else {
    return refused("[inputs] of the machine file does not name it");
  }
  return by_->give(inputs);
}

}  // namespace kerf::program
