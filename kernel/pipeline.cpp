#include "kernel/pipeline.hpp"

#include <cassert>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include "kernel/plan_notes.hpp"
#include "kernel/reader_options.hpp"
#include "lookahead/planner.hpp"

namespace kerf {

namespace {

constexpr double kRounding = 1e-9;

}  // namespace

Pipeline::Pipeline(const Order& order)
    : observer_(order.path.observer),
      planner_({.limits = order.settings.limits,
                .profile = profiles::Profile(order.options.profile),
                .window_blocks = order.options.window_blocks,
                .longest_phase_s = order.longest_phase_s,
                .waits = order.options.waits && order.may_hold,
                .optional_stop = order.options.optional_stop,
                .event_time = event_time_settings(order.settings, order.options),
                .may_hold = order.may_hold,
                .observer = order.options.plan_log
                                ? std::make_shared<const PlanNotes>(order.options.plan_log)
                                : nullptr}),
      source_(order.settings, order.options,
              {.path = order.path,
               .scan = planner_.scan_for(),
               .reads_apart = order.options.reads_apart}),
      period_s_(order.settings.limits.period_s) {}

Pipeline::Step Pipeline::step(lookahead::Outbox& outbox) {
  assert(outbox.phases.empty());
  if (planner_.emit(outbox)) {
    check_.emitted(outbox);
    if (observer_ != nullptr) {
      observer_->planned(outbox);
    }
    return Step::planned;
  }
  if (planner_.is_held() || planner_.waits() || planner_.awaits_answer()) {
    return Step::held;
  }
  if (finished_) {
    return Step::ended;
  }
  return take_next() ? Step::took : Step::wants_text;
}

bool Pipeline::take_next() {
  for (bool probes = true; probes;) {
    std::optional<ProgramItem> item = source_.next();
    if (!item) {
      return false;
    }
    if (std::holds_alternative<ProgramEnd>(*item)) {
      check_.judge(path().deviations().worst);
      planner_.finish(path().line());
      finished_ = true;
      if (observer_ != nullptr) {
        observer_->ended();
      }
    } else if (const auto* pause = std::get_if<parser::Move>(&*item)) {
      push_rest(*pause);
    }
    // Nothing of a probe's motion is planned before the wait after it is known.
    probes = std::holds_alternative<BlockItem>(*item) && asking_ == Asking::motion_follows;
    if (auto* motion = std::get_if<BlockItem>(&*item)) {
      push_block(std::move(*motion));
    }
  }
  return true;
}

void Pipeline::push_rest(const parser::Move& pause) {
  note_question(pause);
  const lookahead::RestTime time = lookahead::push_pause(pause, planner_);
  if (observer_ != nullptr) {
    observer_->rest(time);
  }
}

void Pipeline::push_block(BlockItem item) {
  if (asking_ == Asking::motion_follows) {
    inquiry_.limits = item.block.limits.ramp;
    asking_ = Asking::ready;
  }
  check_.pushed(item.block);
  if (observer_ != nullptr) {
    observer_->pushed(item.block);
  }
  lookahead::push_block(std::move(item.block), item.changes, planner_);
}

// Of a probe it comes before the motion, which may be too short to be any.
void Pipeline::note_question(const parser::Move& pause) {
  const auto* event = std::get_if<parser::EventMove>(&pause.shape);
  const bool begins = event != nullptr && event->kind == parser::EventKind::probe_begin;
  if (!begins && (event == nullptr || event->kind != parser::EventKind::ask_machine)) {
    return;
  }
  if (asking_ == Asking::nothing) {
    const auto ticks = [this](double time_s) {
      return static_cast<std::int64_t>(std::ceil(time_s / period_s_ - kRounding));
    };
    static_assert(static_cast<int>(interp::Inquiry::Kind::at_speed) ==
                  static_cast<int>(parser::MachineQuestion::Kind::at_speed));
    inquiry_ = {.block = pause.block,
                .kind = static_cast<interp::Inquiry::Kind>(event->question.kind),
                .channel = static_cast<std::size_t>(event->question.channel),
                .max_ticks = ticks(event->question.max_wait_s),
                .pause_ticks = ticks(kPauseBehindAnswer_s)};
  }
  if (asking_ != Asking::asked) {
    asking_ = begins ? Asking::motion_follows : Asking::ready;
  }
}

std::optional<interp::Inquiry> Pipeline::take_inquiry() {
  if (asking_ != Asking::ready) {
    return std::nullopt;
  }
  asking_ = Asking::asked;
  return inquiry_;
}

void Pipeline::follow(const interp::InquiryAnswer& answer) {
  if (answer.has_braked) {
    check_.braked(planner_.follow_probe({.tick = answer.brake_tick,
                                         .plan = answer.plan,
                                         .laws = {answer.law.data(), answer.laws},
                                         .rest_tick = answer.rest_tick}));
  } else {
    planner_.resume();
  }
  asking_ = Asking::nothing;
  const std::uint32_t line = source_.answer({.found = answer.found,
                                             .at_start = answer.at_start,
                                             .value = answer.value,
                                             .place_mm = answer.place_mm,
                                             .rest_mm = answer.rest_mm});
  if (finished_) {
    return;  // a stop has come right after the answer
  }
  planner_.push_rest(
      static_cast<double>(inquiry_.pause_ticks) * period_s_,
      {.line = line, .run_block = inquiry_.block, .follows = {.feed = false, .feed_stop = false}});
}

bool Pipeline::hold(const lookahead::StopOrder& order, lookahead::Outbox& outbox) {
  return took_over(planner_.hold(order, outbox), outbox);
}

bool Pipeline::hold_feed(const lookahead::StopOrder& order, lookahead::Outbox& outbox) {
  return took_over(planner_.hold_feed(order, outbox), outbox);
}

std::optional<lookahead::Planner::ChangedPlan> Pipeline::change_plan(
    const lookahead::Planner::PlanChange& change, lookahead::Outbox& outbox) {
  auto changed = planner_.change_plan(change, outbox);
  if (changed) {
    const std::uint64_t from_curve = outbox.phases.empty() ? 0 : outbox.phases.front().curve;
    check_.overridden(change.by, {.from_curve = from_curve, .to_curve = changed->slows_to_curve});
    took_over(true, outbox);
  }
  return changed;
}

bool Pipeline::stop(const lookahead::StopOrder& order, lookahead::Outbox& outbox) {
  if (!planner_.stop(order, outbox)) {
    return false;
  }
  finished_ = true;
  check_.stop();
  return took_over(true, outbox);
}

void Pipeline::follow_stop_ahead(const lookahead::Planner::PlannedStopAhead& taken) {
  took_over(true, planner_.follow_stop_ahead(taken));
}

void Pipeline::stop_held() {
  finished_ = true;
  check_.stop();
  planner_.stop_held();
}

bool Pipeline::took_over(bool found, const lookahead::Outbox& outbox) {
  if (!outbox.phases.empty()) {
    check_.taken_over();
    check_.emitted(outbox);
  }
  return found;
}

void Pipeline::forget_before(std::int64_t tick) {
  planner_.forget_before(tick);
  check_.forget_before(planner_.oldest_curve());
}

void Pipeline::fail_without_plan(std::uint32_t line) {
  check_.fail(line, "the program is read and nothing is planned");
}

}  // namespace kerf
