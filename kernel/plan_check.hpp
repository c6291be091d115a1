// Checks the plan against the blocks that it was made for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <kerf/report.hpp>

#include "lookahead/emit/emitter.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/feed_override.hpp"
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
  // The next phases are of a plan that takes over from what was emitted before.
  void taken_over() { takes_over_ = true; }
  // Whether the tick side took that plan. If not, what was emitted before goes on.
  void settle(bool accepted);
  // Blocks may be as fast as the override makes them; on the curves on which the motion may slow
  // down still, as fast as they might be before it. from_curve 0: no plan takes over for it.
  struct SlowingCurves {
    std::uint64_t from_curve = 0;
    std::uint64_t to_curve = 0;
  };
  void overridden(const lookahead::FeedOverride& by, const SlowingCurves& slowing);
  // The tick side has braked like this, and the block ends there. It was as fast as the plan, which
  // an override that came since does not change.
  void braked(const lookahead::Outbox& outbox);
  // Motion on the curves before this one is run, or never taken back.
  void forget_before(std::uint64_t curve);
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
    double feedrate_mm_s = 0.0;  // that the limits leave without an override
    double programmed_mm_s = 0.0;
    parser::FollowedOverrides follows{};
    bool rapid = false;
    bool is_bound_by_chord = false;  // the ticks bind it, which overrides do not slow down
    bool adds_to_path = true;
  };

  // The plan can be run, but is not what it should be.
  void note(std::uint32_t line, std::string what);
  void check(const interp::Phase& phase);
  void check_rest(const interp::Phase& phase, bool takes_over);
  void take_over(const interp::Phase& phase);
  void begin_block(const interp::Phase& phase);
  void leave_block();
  [[nodiscard]] double max_mm_s(const Expected& block) const;
  [[nodiscard]] bool is_empty() const { return front_ == expected_.size(); }
  [[nodiscard]] const Expected& front() const { return expected_[front_]; }

  lookahead::Window<Expected> expected_;
  std::size_t front_ = 0;        // of expected_: the block that is being emitted
  std::uint64_t forgotten_ = 0;  // blocks that were expected before the first
  bool takes_over_ = false;
  bool brakes_ = false;
  struct Place {
    std::uint64_t front = 0;  // counted from the first block of all
    bool begun = false;
    std::uint64_t curve = 0;
    double s_mm = 0.0;
    double path_mm = 0.0;
  };
  std::optional<Place> before_takeover_{};
  std::uint64_t planned_to_curve_ = 0;  // before a plan took over
  bool begun_ = false;                  // the front block has begun
  std::uint64_t curve_ = 0;             // curve number of the front block, else of the one before
  double s_mm_ = 0.0;                   // position on it
  double path_mm_ = 0.0;                // length of the blocks before the front
  std::uint32_t idle_ = 0;              // calls in a row that brought nothing
  struct Overridden {
    lookahead::FeedOverride by{};
    lookahead::FeedOverride before{};  // the most of each before the override, while it slows down
    double room = 1.0;                 // above that, more with each override on the way down
    std::uint64_t slows_to_curve = 0;
  };
  Overridden overridden_{};
  std::optional<Overridden> before_override_{};  // that is not settled yet
  bool stopped_ = false;
  bool ended_ = false;
  bool broken_ = false;
  std::optional<RunFault> fault_;
};

}  // namespace kerf
