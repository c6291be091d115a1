// The classical schedule: ACC + CF + DEC between the valleys of the velocity limit curve.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "lookahead/classical/velocity_pass.hpp"
#include "lookahead/emit/schedule.hpp"
#include "lookahead/path/plan_observer.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

// A segment is emitted once half a window of blocks is known after it, or once the program rests
// there anyway. Amortised, each block is visited twice by the backward pass and once by the forward
// pass, whatever the length of the program.
class ClassicalSchedule final : public Schedule {
 public:
  struct Settings {
    PlanLimits limits{};
    profiles::Profile profile{profiles::ProfileKind::s_curve};
    std::size_t ready_blocks = 500;  // leave a full window before it is planned again; >= 1
    // A cruise leaves in parts of this duration.
    double longest_cruise_s = 0.1;
    std::shared_ptr<const PlanObserver> observer{};  // null: nobody is told
  };

  explicit ClassicalSchedule(Settings settings) : settings_(std::move(settings)) {}

  // For what is pushed next. Precondition: empty.
  void use(const profiles::Profile& profile);
  void push(const Window<Block>& blocks) override;
  // before: the block that it joins; null: it begins at rest.
  void push(const Block& block, const Block* before);
  // Begins in motion, at an acceleration of 0, on what was pushed. False: it cannot, from there.
  [[nodiscard]] bool begin(double v_mm_s);
  [[nodiscard]] bool empty() const override { return window_.empty(); }
  [[nodiscard]] bool has_room() const override { return true; }
  bool emit(Window<Block>& blocks, Supply supply, Emitter& emitter, Outbox& outbox) override;

 private:
  SegmentPlan plan_front(SegmentEnds& ends);
  void tell_front(const SegmentEnds& ends, const SegmentPlan& plan, const Block& block) const;
  void plan_window(Supply supply);
  void emit_cruise(const Block& block, const SegmentPlan& plan, Emitter& emitter, Outbox& outbox);
  void emit_plan(const Block& block, const SegmentPlan& plan, Emitter& emitter,
                 Outbox& outbox) const;
  void leave_segment(Window<Block>& blocks, Emitter& emitter);

  Settings settings_;
  Window<WindowSegment> window_;
  std::size_t ready_segments_ = 0;  // of window_, planned and allowed to leave
  bool to_rest_ = false;
  double v_mm_s_ = 0.0;  // at the end of what was emitted
  // The rest of the front segment's plan once a part of it was emitted; valid as long as the
  // segment ends as planned.
  std::optional<SegmentPlan> left_;
  double left_end_mm_s_ = 0.0;
};

}  // namespace kerf::lookahead
