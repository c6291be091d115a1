#include "kernel/plan_check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curves/curve_error.hpp"

namespace kerf {

using curves::to_text;

namespace {

constexpr std::uint32_t kMaxIdle = 1000;
// What rounding leaves between the way that a law covers and that of its phase.
constexpr double kWay_mm = 1e-7;
constexpr double kRelative = 1e-9;
constexpr double kDeviation_mm = 1e-9;
constexpr double kFeedrateRelative = 1e-6;
constexpr double kFeedrate_mm_s = 1e-9;
// The room that a motion has that slows down, above what it was allowed (lookahead/path/slowing).
constexpr double kSlowing = 1.001;

}  // namespace

void PlanCheck::pushed(const lookahead::Block& block) {
  expected_.push_back({.line = block.line,
                       .length_mm = block.length_mm,
                       .feedrate_mm_s = block.along.feedrate_mm_s,
                       .programmed_mm_s = block.feedrate_mm_s,
                       .follows = block.follows,
                       .rapid = block.rapid,
                       .is_bound_by_chord = block.along.from.feedrate == Constraint::chord_error,
                       .adds_to_path = !block.extra.alone});
}

void PlanCheck::fail(std::uint32_t line, std::string what) {
  broken_ = true;
  note(line, std::move(what));
}

void PlanCheck::note(std::uint32_t line, std::string what) {
  if (!fault_) {
    fault_ = RunFault{.line = line, .what = std::move(what)};
  }
}

void PlanCheck::emitted(const lookahead::Outbox& outbox) {
  bool moves = false;
  for (const interp::Phase& phase : outbox.phases) {
    const bool takes_over = takes_over_;
    if (takes_over) {
      take_over(phase);
    }
    const bool rests =
        phase.s_begin_mm == phase.s_end_mm && phase.ends_at_rest && phase.law.length_mm() == 0.0;
    if (rests) {
      check_rest(phase, takes_over);
    } else {
      check(phase);
    }
    moves = moves || rests || phase.s_end_mm > phase.s_begin_mm;
  }
  idle_ = moves ? 0 : idle_ + 1;
  if (idle_ > kMaxIdle) {
    fail(is_empty() ? 0 : front().line, "the plan goes on and comes nowhere");
  }
}

// At its end a block may still have phases: what rounding left of a segment.
void PlanCheck::leave_block() {
  if (begun_ && s_mm_ == front().length_mm) {
    path_mm_ += front().adds_to_path ? s_mm_ : 0.0;
    ++front_;
    begun_ = false;
  }
}

void PlanCheck::braked(const lookahead::Outbox& outbox) {
  if (!outbox.phases.empty()) {
    taken_over();
    brakes_ = true;
    emitted(outbox);
    brakes_ = false;
  }
  settle(true);
  if (begun_) {
    expected_[front_].length_mm = s_mm_;
    leave_block();
  }
}

void PlanCheck::forget_before(std::uint64_t curve) {
  for (; front_ > 0 && forgotten_ + 1 < curve; ++forgotten_, --front_) {
    expected_.pop_front();
  }
}

// Whether the new plan has the tool where the old one had it, its ticks show.
void PlanCheck::take_over(const interp::Phase& phase) {
  takes_over_ = false;
  leave_block();
  before_takeover_ = Place{.front = forgotten_ + front_,
                           .begun = begun_,
                           .curve = curve_,
                           .s_mm = s_mm_,
                           .path_mm = path_mm_};
  planned_to_curve_ = std::max(planned_to_curve_, curve_);
  // Where a block is planned to its end, another plan may begin with the next.
  const bool is_next = !begun_ && phase.curve == curve_ + 1 && phase.s_begin_mm == 0.0 &&
                       phase.path_begin_mm == path_mm_ && !is_empty();
  if ((phase.curve > planned_to_curve_ && !is_next) || phase.curve < forgotten_) {
    fail(phase.line, "a plan takes over on block " + std::to_string(phase.curve) + ", and blocks " +
                         std::to_string(forgotten_ + 1) + " to " +
                         std::to_string(planned_to_curve_) + " are planned");
    return;
  }
  curve_ = phase.curve;
  s_mm_ = phase.s_begin_mm;
  path_mm_ = phase.path_begin_mm;
  front_ = phase.curve - forgotten_;
  begun_ = false;
  if (front_ > 0) {
    --front_;
    begun_ = true;
    leave_block();
  }
}

void PlanCheck::settle(bool accepted) {
  if (!accepted && before_takeover_) {
    front_ = before_takeover_->front - forgotten_;
    begun_ = before_takeover_->begun;
    curve_ = before_takeover_->curve;
    s_mm_ = before_takeover_->s_mm;
    path_mm_ = before_takeover_->path_mm;
  }
  if (!accepted && before_override_) {
    overridden_ = *before_override_;
  }
  before_takeover_.reset();
  before_override_.reset();
}

// A plan may take over where the tool rests: that it does, its ticks show.
void PlanCheck::check_rest(const interp::Phase& phase, bool takes_over) {
  leave_block();
  ended_ = ended_ || phase.ends_program;
  if (!(phase.law.duration_s() >= 0.0) || !std::isfinite(phase.law.duration_s())) {
    fail(phase.line, "a rest of " + to_text(phase.law.duration_s()) + " s is planned");
  }
  if (!stopped_ && !phase.holds && !takes_over && !is_empty() && (begun_ || phase.ends_program)) {
    fail(front().line, std::string(phase.ends_program ? "the program ends" : "a rest is planned") +
                           " at " + to_text(s_mm_) + " mm of a block of " +
                           to_text(front().length_mm) + " mm");
  }
}

void PlanCheck::overridden(const lookahead::FeedOverride& by, const SlowingCurves& slowing) {
  const Overridden was = overridden_;
  if (slowing.from_curve != 0) {
    before_override_ = was;
  }
  // Where nothing is to slow down the tool may still brake for a hold, and go on before its rest.
  const std::uint64_t from_curve = slowing.from_curve != 0 ? slowing.from_curve : curve_;
  const std::uint64_t to_curve = slowing.from_curve != 0 ? slowing.to_curve : curve_;
  const bool slows = from_curve <= was.slows_to_curve;
  const auto most = [slows](double before, double by_now) {
    return slows ? std::max(before, by_now) : by_now;
  };
  overridden_ = {.by = by,
                 .before = {.feed = most(was.before.feed, was.by.feed),
                            .rapid = most(was.before.rapid, was.by.rapid),
                            .spindle = most(was.before.spindle, was.by.spindle),
                            .adaptive = most(was.before.adaptive, was.by.adaptive)},
                 .room = slows ? kSlowing * was.room : kSlowing,
                 .slows_to_curve = slows ? std::max(was.slows_to_curve, to_curve) : to_curve};
}

// What the machine allows above the programmed feedrate, the ticks show.
double PlanCheck::max_mm_s(const Expected& block) const {
  const auto under = [&block](const lookahead::FeedOverride& by) {
    if (block.rapid && block.is_bound_by_chord) {
      return block.feedrate_mm_s;
    }
    if (block.rapid) {
      return lookahead::share_of_rapid(by, block.follows) * block.feedrate_mm_s;
    }
    const double share = lookahead::share_of(by, block.follows);
    const double max_mm_s = share * block.programmed_mm_s;
    return share > 1.0 ? max_mm_s : std::min(block.feedrate_mm_s, max_mm_s);
  };
  const double now_mm_s = under(overridden_.by);
  return curve_ <= overridden_.slows_to_curve
             ? std::max(now_mm_s, overridden_.room * under(overridden_.before))
             : now_mm_s;
}

void PlanCheck::judge(const smoothing::PathDeviation& deviation) {
  if (!(deviation.distance_mm <= deviation.tolerance_mm * (1.0 + kRelative) + kDeviation_mm)) {
    note(deviation.line, "the path is " + to_text(deviation.distance_mm) +
                             " mm from the programmed one, above " +
                             to_text(deviation.tolerance_mm) + " mm");
  }
}

void PlanCheck::begin_block(const interp::Phase& phase) {
  begun_ = true;
  s_mm_ = 0.0;
  if (phase.curve != curve_ + 1 || phase.path_begin_mm != path_mm_) {
    fail(phase.line, "block " + std::to_string(phase.curve) + " is planned after block " +
                         std::to_string(curve_) + ", at " + to_text(phase.path_begin_mm) +
                         " mm of the path where " + to_text(path_mm_) + " mm are planned");
  }
  curve_ = phase.curve;
}

void PlanCheck::check(const interp::Phase& phase) {
  if (phase.curve != curve_) {
    leave_block();
  }
  if (is_empty()) {
    fail(phase.line, "motion is planned after the last block");
    return;
  }
  if (!begun_) {
    begin_block(phase);
  }
  const Expected block = front();
  if (phase.curve != curve_ || phase.s_begin_mm != s_mm_) {
    fail(phase.line, "the plan goes on at " + to_text(phase.s_begin_mm) + " mm of block " +
                         std::to_string(phase.curve) + " and has come to " + to_text(s_mm_) +
                         " mm of block " + std::to_string(curve_));
  }
  const double way_mm = phase.s_end_mm - phase.s_begin_mm;
  const double covered_mm = phase.law.length_mm();
  if (!(way_mm >= 0.0) || !(phase.s_end_mm <= block.length_mm) ||
      !(std::abs(way_mm - covered_mm) <= kWay_mm + kRelative * phase.s_end_mm) ||
      !std::isfinite(phase.law.duration_s())) {
    fail(phase.line, "from " + to_text(phase.s_begin_mm) + " to " + to_text(phase.s_end_mm) +
                         " mm of a block of " + to_text(block.length_mm) + " mm the plan covers " +
                         to_text(covered_mm) + " mm in " + to_text(phase.law.duration_s()) + " s");
  }
  const profiles::Ramp ramp = phase.law.ramp();
  const double max_mm_s = this->max_mm_s(block);
  if (!brakes_ && !(std::max(ramp.v_begin_mm_s, ramp.v_end_mm_s) <=
                    max_mm_s * (1.0 + kFeedrateRelative) + kFeedrate_mm_s)) {
    note(phase.line, "a feedrate of " + to_text(std::max(ramp.v_begin_mm_s, ramp.v_end_mm_s)) +
                         " mm/s is planned, above " + to_text(max_mm_s) + " mm/s");
  }
  s_mm_ = phase.s_end_mm;
}

}  // namespace kerf
