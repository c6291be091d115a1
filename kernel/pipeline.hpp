// A program's text to its plan: reader, smoothing, blocks and look-ahead, wired once.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "kernel/plan_check.hpp"
#include "kernel/program_path.hpp"
#include "lookahead/planner.hpp"

namespace kerf {

// Whatever makes a plan of a program makes it here: the kernel that runs it, the estimate of its
// time, the explanation of a line. So they plan one path. The plan is held against the program's
// blocks (PlanCheck). One thread.
class Pipeline {
 public:
  struct Order {
    const MachineSettings& settings;
    const KernelOptions& options;
    double longest_cruise_s = lookahead::PlannerSettings{}.longest_cruise_s;
    ProgramPath::Order path{};
  };
  enum class Step : unsigned char {
    planned,     // something is in the outbox
    took,        // something of the program is on its way
    wants_text,  // feed() or finish() must come first
    ended,       // the program is planned to its end, or to where it was stopped
  };

  explicit Pipeline(const Order& order);

  void feed(std::string_view text) { path_.feed(text); }
  void finish() { path_.finish(); }
  // Nothing is run, for a reason that is not in the text.
  void refuse(diagnostics::Diagnostic fault) { path_.refuse(std::move(fault)); }

  // One step. Precondition: the outbox is empty.
  Step step(lookahead::Outbox& outbox);

  // What is held back for the sake of what follows comes out without it.
  void flush() { path_.flush(); }
  // The plan ends at rest behind what was read, until more is.
  void plan_to_rest() { planner_.plan_to_rest(); }
  // The plan ends at rest as soon as the limits allow.
  void stop();

  // All of the program is read and on its way, or it was stopped.
  [[nodiscard]] bool is_finished() const noexcept { return finished_; }
  [[nodiscard]] const ProgramPath& path() const noexcept { return path_; }
  [[nodiscard]] const PlanTotals& totals() const noexcept { return planner_.totals(); }
  [[nodiscard]] const PlanCheck& check() const noexcept { return check_; }
  // The program is read and no plan of its end came.
  void fail_without_plan(std::uint32_t line);

 private:
  // What is next of the program into the window. False: there is no more text.
  bool take_next();
  void push_segment(smoothing::PathSegment segment);

  PipelineObserver* observer_;
  lookahead::PlanLimits limits_;
  ProgramPath path_;
  lookahead::Planner planner_;
  PlanCheck check_;
  bool finished_ = false;
};

}  // namespace kerf
