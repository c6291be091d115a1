#include "kernel/delivery.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace kerf {

namespace {

// Once they are all sent, or as many as a ring holds: what is moved up each time is little. Returns
// how many.
template <typename T>
std::size_t forget_front(std::vector<T>& values, std::size_t of_ring, std::size_t& sent) {
  if (sent < values.size() && sent < of_ring) {
    return 0;
  }
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(sent));
  return std::exchange(sent, 0);
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

std::int64_t first_tick(const interp::TickTime& begin) {
  return begin.tick + (begin.offset_s > 0.0 ? 1 : 0);
}

}  // namespace

void Delivery::send_path() {
  while (pieces_sent_ < outbox_.pieces.size() && queue_->push(outbox_.pieces[pieces_sent_])) {
    ++pieces_sent_;
  }
  while (line_changes_sent_ < outbox_.line_changes.size() &&
         queue_->push(outbox_.line_changes[line_changes_sent_])) {
    ++line_changes_sent_;
  }
  while (output_changes_sent_ < outbox_.output_changes.size() &&
         queue_->push(outbox_.output_changes[output_changes_sent_])) {
    ++output_changes_sent_;
  }
}

bool Delivery::deliver(std::int64_t horizon) {
  return deliver(Until{.horizon = horizon, .phases_free = interp::MotionQueue::kPhasesKeptFree});
}

bool Delivery::deliver(const Until& until) {
  send_path();
  while (phases_sent_ < outbox_.phases.size() && queue_->phases_free() > until.phases_free) {
    const interp::Phase& phase = outbox_.phases[phases_sent_];
    if (phase.begin.tick > until.horizon) {
      break;
    }
    send_changes_before(phase);
    if (!may_follow(phase) || !queue_->push(phase)) {
      break;
    }
    output_changes_counted_ = phase.output_changes;
    frozen_until_tick_ = phase.begin.tick;
    last_ = phase;
    ++phases_sent_;
  }
  forget_sent();
  return outbox_.phases.empty();
}

Delivery::HandedOver Delivery::take_over(lookahead::Outbox&& plan, std::uint32_t from,
                                         const lookahead::Planner::PlannedStopAhead* ahead) {
  const interp::TickTime begin = plan.phases.front().begin;
  const std::uint32_t takeover_plan = plan.phases.front().plan;
  append_path(plan);
  if (ahead != nullptr) {
    append_path(ahead->outbox);
  }
  send_path();
  if (queue_->phases_free() < outbox_.phases.size() + plan.phases.size() ||
      !may_end_with(plan.phases.back()) ||
      (ahead != nullptr && !write_stop(*ahead, takeover_plan))) {
    return HandedOver::no;
  }
  const auto later = std::ranges::find_if(
      outbox_.phases.begin() + static_cast<std::ptrdiff_t>(phases_sent_), outbox_.phases.end(),
      [&begin](const interp::Phase& phase) {
        return phase.begin.tick > begin.tick ||
               (phase.begin.tick == begin.tick && phase.begin.offset_s >= begin.offset_s);
      });
  const bool drops = later != outbox_.phases.end();
  outbox_.phases.erase(later, outbox_.phases.end());
  append(outbox_.phases, plan.phases);
  deliver(Until{.horizon = std::numeric_limits<std::int64_t>::max(), .phases_free = 0});
  look_();
  queue_->push(interp::Takeover{.from = from,
                                .plan = takeover_plan,
                                .tick = first_tick(begin),
                                .phases_end = queue_->phases_pushed()});
  queue_->commit(ahead != nullptr ? interp::MotionQueue::Ahead::beside
                                  : interp::MotionQueue::Ahead::same);
  return drops ? HandedOver::for_good : HandedOver::whole;
}

void Delivery::append_path(const lookahead::Outbox& plan) {
  append(outbox_.pieces, plan.pieces);
  append(outbox_.line_changes, plan.line_changes);
  append(outbox_.output_changes, plan.output_changes);
}

Delivery::Committed Delivery::commit(const lookahead::Planner::PlannedStopAhead& ahead,
                                     std::uint32_t from) {
  append_path(ahead.outbox);
  send_path();
  if (!write_stop(ahead, from)) {
    return Committed::no_room;
  }
  return commit(interp::MotionQueue::Ahead::written) ? Committed::yes : Committed::stop_taken;
}

double Delivery::missing_mm(const lookahead::Planner::PlannedStopAhead& ahead) const {
  const interp::Phase& last = ahead.outbox.phases.back();
  double missing = 0.0;
  for (std::size_t i = pieces_sent_; i < outbox_.pieces.size(); ++i) {
    const interp::CurvePiece& piece = outbox_.pieces[i];
    const double begin = curves::s_begin_mm(piece.geometry);
    if (piece.curve > last.curve || (piece.curve == last.curve && begin >= last.s_end_mm)) {
      break;
    }
    const double end = curves::s_end_mm(piece.geometry);
    missing += (piece.curve == last.curve ? std::min(end, last.s_end_mm) : end) - begin;
  }
  return missing;
}

bool Delivery::write_stop(const lookahead::Planner::PlannedStopAhead& ahead, std::uint32_t from) {
  const std::vector<interp::Phase>& phases = ahead.outbox.phases;
  if (phases.size() > interp::StopAhead::kPhases || !may_end_with(phases.back())) {
    return false;
  }
  interp::StopAhead& stop = queue_->spare_stop();
  stop.from = from;
  stop.plan = ahead.plan;
  stop.tick = first_tick(phases.front().begin);
  stop.count = phases.size();
  std::ranges::copy(phases, stop.phases.begin());
  return true;
}

void Delivery::follow_stop() {
  outbox_.phases.clear();
  phases_sent_ = 0;
  look_();
  queue_->release_stop();
}

// Where a phase waits for more changes than the ring holds, those that are in it go ahead: a rest
// of no duration counts them.
void Delivery::send_changes_before(const interp::Phase& phase) {
  const std::uint64_t sent = output_changes_gone_ + output_changes_sent_;
  if (sent >= phase.output_changes || sent == output_changes_counted_) {
    return;
  }
  interp::Phase rest = phase;
  rest.s_end_mm = rest.s_begin_mm;
  rest.law = profiles::Transition::rest(0.0);
  rest.output_changes = sent;
  rest.ends_at_rest = true;
  rest.ends_program = rest.holds = false;
  if (queue_->push(rest)) {
    output_changes_counted_ = sent;
  }
}

// Pieces and lines may wait for a long time, after a curve of more of them than a ring holds.
void Delivery::forget_sent() {
  if (phases_sent_ == outbox_.phases.size()) {
    outbox_.phases.clear();
    phases_sent_ = 0;
  }
  output_changes_gone_ += forget_front(outbox_.output_changes, interp::MotionQueue::kOutputChanges,
                                       output_changes_sent_);
  forget_front(outbox_.pieces, interp::MotionQueue::kPieces, pieces_sent_);
  forget_front(outbox_.line_changes, interp::MotionQueue::kLineChanges, line_changes_sent_);
}

bool Delivery::may_follow(const interp::Phase& phase) const {
  return output_changes_gone_ + output_changes_sent_ >= phase.output_changes &&
         reaches(phase.curve, phase.s_begin_mm);
}

bool Delivery::may_end_with(const interp::Phase& phase) const {
  return output_changes_gone_ + output_changes_sent_ >= phase.output_changes &&
         reaches(phase.curve, phase.s_end_mm);
}

bool Delivery::reaches(std::uint64_t on_curve, double at_mm) const {
  const auto begins_before = [on_curve, at_mm](std::uint64_t curve, double s_mm) {
    return on_curve < curve || (on_curve == curve && at_mm < s_mm);
  };
  if (line_changes_sent_ < outbox_.line_changes.size()) {
    const interp::LineChange& waiting = outbox_.line_changes[line_changes_sent_];
    if (!begins_before(waiting.curve, waiting.s_mm)) {
      return false;
    }
  }
  if (pieces_sent_ == outbox_.pieces.size()) {
    return true;
  }
  const interp::CurvePiece& waiting = outbox_.pieces[pieces_sent_];
  return begins_before(waiting.curve, curves::s_begin_mm(waiting.geometry));
}

}  // namespace kerf
