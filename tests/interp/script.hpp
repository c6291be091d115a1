// Motion made by hand for the tests of the interpolator.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "interp/interpolator.hpp"
#include "profiles/profile.hpp"

namespace kerf::interp::test {

using curves::Arc;
using curves::Line;
using curves::NurbsCurve;
using profiles::Profile;
using profiles::ProfileKind;
using profiles::Transition;

inline constexpr double kTs = 0.001;
inline constexpr profiles::RampLimits kRamp{.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 2e4};

// Pushes laws one after the other along curves, as the planner does.
class Script {
 public:
  explicit Script(const Position& start_mm = {})
      : queue_(std::make_unique<MotionQueue>()),
        interpolator_(std::make_unique<Interpolator>(*queue_, kTs, start_mm)) {}

  void curve(const curves::Curve& curve, const std::vector<LineChange>& changes = {}) {
    path_begin_mm_ += s_mm_;
    s_mm_ = 0.0;
    ++curve_;
    has_changes_ = !changes.empty();
    for (LineChange change : changes) {
      change.curve = curve_;
      ASSERT_TRUE(queue_->push(change));
    }
    curves::for_each_piece(curve, [this](const curves::Piece& piece) {
      ASSERT_TRUE(queue_->push(CurvePiece{.curve = curve_, .geometry = piece}));
    });
  }

  void law(const Transition& law) { push(law, s_mm_ + law.length_mm(), {}); }
  // The last of a motion: the next one begins on a tick.
  void law_to_rest(const Transition& law, double s_end_mm) {
    EXPECT_NEAR(s_mm_ + law.length_mm(), s_end_mm, 1e-9);
    push(law, s_end_mm, {.at_rest = true});
    to_next_tick();
  }
  void rest(double duration_s, bool ends_program) {
    has_changes_ = false;
    push(Transition::rest(duration_s), s_mm_, {.at_rest = true, .program = ends_program});
    to_next_tick();
  }

  Interpolator& interpolator() { return *interpolator_; }
  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] const std::vector<Phase>& phases() const { return phases_; }

  // From rest to rest over length_mm, by one profile, without a cruise.
  void hill(double length_mm, const Profile& profile) {
    const double v = profile.peak_mm_s({}, {.length_mm = length_mm, .v_cap_mm_s = 1e9}, kRamp);
    law(profile.fastest({0.0, v}, kRamp));
    law_to_rest(profile.fastest({v, 0.0}, kRamp), length_mm);
  }

 private:
  struct Ends {
    bool at_rest = false;
    bool program = false;
  };
  void push(const Transition& law, double s_end_mm, const Ends& ends) {
    const double tick = std::floor(time_s_ / kTs + 1e-9);
    Phase phase{.curve = curve_,
                .begin = {.tick = static_cast<std::int64_t>(tick),
                          .offset_s = std::max(time_s_ - tick * kTs, 0.0)},
                .s_begin_mm = s_mm_,
                .s_end_mm = s_end_mm,
                .path_begin_mm = path_begin_mm_,
                .law = law,
                .line = 3,
                .has_changes = has_changes_,
                .ends_at_rest = ends.at_rest,
                .ends_program = ends.program};
    ASSERT_TRUE(queue_->push(phase));
    queue_->commit();
    phases_.push_back(phase);
    s_mm_ = phase.s_end_mm;
    time_s_ += law.duration_s();
  }
  void to_next_tick() { time_s_ = std::ceil(time_s_ / kTs - 1e-9) * kTs; }

  std::unique_ptr<MotionQueue> queue_;
  std::unique_ptr<Interpolator> interpolator_;
  std::vector<Phase> phases_;
  std::uint64_t curve_ = 0;
  bool has_changes_ = false;
  double s_mm_ = 0.0;
  double path_begin_mm_ = 0.0;
  double time_s_ = 0.0;
};

inline Line line(const Position& from, const Position& to) {
  return Line::between(from, to).value();
}

}  // namespace kerf::interp::test
