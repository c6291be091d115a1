#include "kernel/delivery.hpp"

namespace kerf {

namespace {

// Once they are all sent, or as many as a ring holds: what is moved up each time is little.
template <typename T>
void forget_front(std::vector<T>& values, std::size_t of_ring, std::size_t& sent) {
  if (sent == values.size() || sent >= of_ring) {
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(sent));
    sent = 0;
  }
}

}  // namespace

bool Delivery::deliver(std::int64_t horizon) {
  while (pieces_sent_ < outbox_.pieces.size() && queue_->push(outbox_.pieces[pieces_sent_])) {
    ++pieces_sent_;
  }
  while (line_changes_sent_ < outbox_.line_changes.size() &&
         queue_->push(outbox_.line_changes[line_changes_sent_])) {
    ++line_changes_sent_;
  }
  while (output_changes_sent_ < outbox_.output_changes.size() &&
         outbox_.output_changes[output_changes_sent_].tick <= horizon &&
         queue_->push(outbox_.output_changes[output_changes_sent_])) {
    ++output_changes_sent_;
  }
  while (phases_sent_ < outbox_.phases.size()) {
    const interp::Phase& phase = outbox_.phases[phases_sent_];
    if (phase.begin.tick > horizon || !may_follow(phase) || !queue_->push(phase)) {
      break;
    }
    frozen_until_tick_ = phase.begin.tick;
    ++phases_sent_;
  }
  forget_sent();
  return outbox_.phases.empty() && outbox_.output_changes.empty();
}

// Pieces and lines may wait for a long time, behind a curve of more of them than a ring holds.
void Delivery::forget_sent() {
  if (phases_sent_ == outbox_.phases.size()) {
    outbox_.phases.clear();
    phases_sent_ = 0;
  }
  if (output_changes_sent_ == outbox_.output_changes.size()) {
    outbox_.output_changes.clear();
    output_changes_sent_ = 0;
  }
  forget_front(outbox_.pieces, interp::MotionQueue::kPieces, pieces_sent_);
  forget_front(outbox_.line_changes, interp::MotionQueue::kLineChanges, line_changes_sent_);
}

bool Delivery::may_follow(const interp::Phase& phase) const {
  if (output_changes_sent_ < outbox_.output_changes.size() &&
      outbox_.output_changes[output_changes_sent_].tick <= phase.begin.tick) {
    return false;
  }
  const auto begins_before = [&phase](std::uint64_t curve, double s_mm) {
    return phase.curve < curve || (phase.curve == curve && phase.s_begin_mm < s_mm);
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
