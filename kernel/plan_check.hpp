// Holds the plan against the blocks that it was made for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <kerf/report.hpp>

#include "lookahead/emit/emitter.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/window.hpp"
#include "smoothing/path_deviations.hpp"

namespace kerf {

// Each block is planned in the order of the program, from its beginning to its end without a gap
// and not above its feedrate, each phase covers the way that it says, the plan goes on, and all of
// the path is planned when the program ends.
class PlanCheck {
 public:
  // In the order in which they go to the planner.
  void pushed(const lookahead::Block& block);
  // All that emit() appended: `outbox` was empty before.
  void emitted(const lookahead::Outbox& outbox);
  // Of the whole program: how far it is led from its path.
  void judge(const smoothing::PathDeviation& deviation);
  // What is left of the program need not come.
  void stop() { stopped_ = true; }

  // The program's end is planned.
  [[nodiscard]] bool has_ended() const { return ended_; }
  // The first; nothing while all holds.
  [[nodiscard]] const std::optional<RunFault>& fault() const { return fault_; }
  // What was planned cannot be run: its segments do not fit.
  [[nodiscard]] bool is_broken() const { return broken_; }
  void fail(std::uint32_t line, std::string what);

 private:
  struct Expected {
    std::uint32_t line = 0;
    double length_mm = 0.0;
    double feedrate_mm_s = 0.0;
    bool adds_to_path = true;
  };

  // The plan can be run, but is not what it should be.
  void note(std::uint32_t line, std::string what);
  void check(const interp::Phase& phase);
  void check_rest(const interp::Phase& phase);
  void begin_block(const interp::Phase& phase);
  void leave_block();

  lookahead::Window<Expected> expected_;  // the front is the block that is being emitted
  bool begun_ = false;                    // the front
  std::uint64_t curve_ = 0;               // its number, or that of the block before
  double s_mm_ = 0.0;                     // on it
  double path_mm_ = 0.0;                  // of the blocks before the front
  std::uint32_t idle_ = 0;                // calls in a row that brought nothing
  bool stopped_ = false;
  bool ended_ = false;
  bool broken_ = false;
  std::optional<RunFault> fault_;
};

}  // namespace kerf
