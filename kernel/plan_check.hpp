// Checks the plan against the blocks that it was made for.
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

// Checks that each block is planned in program order, from its beginning to its end, without gaps
// and not above its feedrate; that each phase covers its stated distance; that planning makes
// progress; and that the whole path is planned when the program ends.
class PlanCheck {
 public:
  // In the order in which they go to the planner.
  void pushed(const lookahead::Block& block);
  // All that emit() appended: `outbox` was empty before.
  void emitted(const lookahead::Outbox& outbox);
  // Checks the deviation of the whole program against its tolerance.
  void judge(const smoothing::PathDeviation& deviation);
  // The rest of the program need not be planned.
  void stop() { stopped_ = true; }

  // The program's end is planned.
  [[nodiscard]] bool has_ended() const { return ended_; }
  // The first fault; nothing while there is none.
  [[nodiscard]] const std::optional<RunFault>& fault() const { return fault_; }
  // The plan cannot be run: its segments do not fit together.
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
  bool begun_ = false;                    // the front block has begun
  std::uint64_t curve_ = 0;               // curve number of the front block, else of the one before
  double s_mm_ = 0.0;                     // position on it
  double path_mm_ = 0.0;                  // length of the blocks before the front
  std::uint32_t idle_ = 0;                // calls in a row that brought nothing
  bool stopped_ = false;
  bool ended_ = false;
  bool broken_ = false;
  std::optional<RunFault> fault_;
};

}  // namespace kerf
