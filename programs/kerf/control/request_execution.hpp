// What a client's request asks of the operator.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "kernel/planned_fault.hpp"
#include "programs/kerf/control/operator.hpp"
#include "programs/kerf/control/request.hpp"

namespace kerf::program {

// Of the thread that plans. Refers to the operator.
class RequestExecution {
 public:
  struct Order {
    FeedInputNumbers feed_inputs{};
    bool machine_has_inputs = false;                        // nobody else says what they are
    ToolTable tools{};                                      // as the run begins
    std::function<bool(const PlannedFault&)> break_down{};  // false: nothing that can be broken
  };
  RequestExecution(Operator& by, Order order) : by_(&by), order_(std::move(order)) {}

  // Precondition: the request is no status, nor for events. The reason of a refusal is good until
  // the next call.
  tl::expected<void, Refusal> carry_out(const ControlRequest& request);

 private:
  tl::expected<void, Refusal> run_mdi(const std::string& line);
  tl::expected<void, Refusal> set_tool(const MeasuredTool& measured);
  tl::expected<void, Refusal> set_input(const ControlRequest& request);

  Operator* by_;
  Order order_;
  std::string wrong_line_;
};

}  // namespace kerf::program
